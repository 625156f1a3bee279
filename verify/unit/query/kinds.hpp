// Bodies of all kinds, and the tables of what each question answers about them. kinds_test.cpp and its neighbours have
// the tables, and ask every question about every two kinds, in both orders.
#pragma once

#include <gtest/gtest.h>

#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ecods/ecods.hpp"

namespace ecods::kinds {

// The letters of the columns of a table.
//
//     M  a surface: a MeshShape, also a point cloud and a height field (of more than one triangle: one counts as convex
//        beside a rounded body)
//     S  a Solid that is not convex
//     C  a ConvexSolid with inner points
//     F  a flat ConvexSolid: a polygon, a segment, a point
//     K  a Rounded with a convex core: a sphere, a capsule, a margin around C, F or one triangle
//     R  a Rounded with another core
//     H  a HalfSpace
constexpr std::string_view letters = "MSCFKRH";

// A body has a letter. Its points of greatest x include (1, 0, 0) if it is on the left, and those of least x (-1, 0, 0)
// if it is on the right; so a left and a right one, translated by (2 + gap, 0, 0), are `gap` from each other if gap is
// positive, and touch if it is 0.
struct Body {
    char letter;
    std::string name;
    std::shared_ptr<const Shape> shape;
    Pose pose;
};
enum class Place : std::uint8_t { left, right };
std::vector<Body> bodies_at(Place place, double gap);

// A pose translated, or turned by a quarter about the z axis of the body.
inline Pose moved(Pose pose, const Vec3& by) {
    pose.t += by;
    return pose;
}
inline Pose turned(const Pose& pose) {
    return {(Mat3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished() * pose.R, pose.t};
}

// Thrown where there is no function for two kinds.
struct NoSuchFunction {};

// A cell of a table:
//
//     +  answered
//     a  answered if the bodies are apart; NotSupported for some that share points
//     s  answered for some bodies of these kinds, and NotSupported for others, wherever they are
//     x  NotSupported
//     -  there is no such function

// A question about two bodies, of which the first is on the left unless is_turned, asks and expects the answer.
struct Case {
    const Body& a;
    const Body& b;
    double gap;
    bool is_turned;

    bool is_known() const noexcept { return gap >= 0; }
    double distance() const noexcept { return gap; }
    double toward() const noexcept { return is_turned ? -1 : 1; }  // x of the direction from a to b
    const Body& left() const noexcept { return is_turned ? b : a; }
};
struct Row {
    const char* name;
    const char* cells;
    std::function<void(const Case&)> ask;
};

// Expects that each question answers what its row says. The cells of a row are those of MM, MS, ..., MH, then those of
// SS, ..., SH, and so on; blanks are ignored.
void expect_table(const std::vector<Row>& rows);

// A question about one body.
struct RowOfOne {
    const char* name;
    const char* cells;
    std::function<void(const Body&)> ask;
};
void expect_table_of_one(const std::vector<RowOfOne>& rows);

// Calls with the body as what its kind is in C++: Posed<MeshShape>, Solid, ConvexSolid, Rounded or HalfSpace.
template <class Call>
auto with_type(const Body& body, const Call& call) {
    const auto as = [&]<class Thing>() {
        return Posed<Thing>(std::dynamic_pointer_cast<const Thing>(body.shape), body.pose);
    };
    switch (body.letter) {
        case 'M':
            return call(as.template operator()<MeshShape>());
        case 'S':
            return call(as.template operator()<Solid>());
        case 'C':
        case 'F':
            return call(as.template operator()<ConvexSolid>());
        case 'H':
            return call(as.template operator()<HalfSpace>());
        default:
            return call(as.template operator()<Rounded>());
    }
}

// Calls `function` with both bodies of the case, in either order if one is a half space, since half_space.hpp takes the
// body first; throws NoSuchFunction if it does not take the two. `take(answer, is_exchanged)` gets the answer.
template <class Function, class Take>
void ask_typed(const Case& c, const Function& function, const Take& take) {
    with_type(c.a, [&](const auto& a) {
        with_type(c.b, [&](const auto& b) {
            if constexpr (std::invocable<Function, decltype(a), decltype(b)>) {
                take(function(a, b), false);
            } else if constexpr (std::invocable<Function, decltype(b), decltype(a)>) {
                take(function(b, a), true);
            } else {
                throw NoSuchFunction();
            }
        });
    });
}

}  // namespace ecods::kinds
