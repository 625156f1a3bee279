// Bodies that turn, and what is expected of their first contact.
#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "ecods/turn.hpp"
#include "unit/query/cast_bodies.hpp"

namespace ecods {

// Half a turn about the z axis takes (5, 0, 0) to (3, 4, 0) at 1 / 3, to (0, 5, 0) at 1 / 2, and to (-3, 4, 0) at 2
// / 3.
inline const Turn half_turn{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()};
// Its tip leads.
inline const std::vector<Vec3> spike{{5, 0, 0}, {4.5, -0.25, 1}, {4.5, -0.25, -1}};
// Faces, in the half-planes that the tip reaches at 1 / 3 and 2 / 3.
inline const std::vector<Vec3> first_wall{{1.5, 2, -2}, {1.5, 2, 2}, {6, 8, 0}};
inline const std::vector<Vec3> second_wall{{-1.5, 2, -2}, {-1.5, 2, 2}, {-6, 8, 0}};

inline Turn about_origin(const Quaternion& q) {
    return {q, Vec3::Zero(), Vec3::Zero()};
}

inline Turn with_glide(const Quaternion& q, const Vec3& glide) {
    return {q, Vec3::Zero(), glide};
}

// The body turns from where its mesh is, the other rests where its mesh is. If the pivot stays, the other one turning
// back meets the first at the same time.
inline Contact cast_turning(const MeshShape& a, const Turn& turn, const MeshShape& b, double max_time = 1) {
    QueryMemory memory;
    const Contact contact = cast(Turning<MeshShape>(a, Pose(), turn), {b, Pose()}, max_time, memory);
    if (turn.pivot_from == turn.pivot_to) {
        const auto& [w, x, y, z] = turn.q;
        const Turn back{{w, -x, -y, -z}, turn.pivot_from, turn.pivot_to};
        const Contact other = cast(Turning<MeshShape>(b, Pose(), back), {a, Pose()}, max_time, memory);
        EXPECT_EQ(contact.has_value(), other.has_value());
        if (contact && other) {
            EXPECT_EQ(contact->time, other->time);
            EXPECT_EQ(contact->kind, other->kind);
        }
    }
    return contact;
}

inline Contact cast_turning(const std::vector<Vec3>& a, const Turn& turn, const std::vector<Vec3>& b,
                            double max_time = 1) {
    return cast_turning(shape_of(a), turn, shape_of(b), max_time);
}

// The polynomial has a root of odd order that rounds to the time: it changes its sign between the numbers half-way to
// the neighbours. Coefficients from the constant one on.
inline void expect_root(const Contact& contact, const std::vector<mpq_class>& coefficients) {
    ASSERT_TRUE(contact);
    const auto sign_half_way = [&](double to) {
        const mpq_class x = (mpq_class(contact->time) + mpq_class(std::nextafter(contact->time, to))) / 2;
        mpq_class sum = 0;
        for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
        return sgn(sum);
    };
    EXPECT_EQ(sign_half_way(0) * sign_half_way(2), -1) << contact->time;
}

}  // namespace ecods
