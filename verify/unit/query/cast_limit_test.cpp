// Casts with a limit of time, casts whose questions are answers of others, and how many triangles are asked exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "base/next.hpp"
#include "cast_bodies.hpp"
#include "query/cast/cast_until.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

// Times that round to one double: of the pairs of triangles that have them, the first features count, whether or not
// it is the pair that has contact first, and whether or not it is within the limit.
TEST(Cast, LimitsAreComparedWithTheRealTime) {
    const MeshShape b = shape_of(flat);
    QueryMemory memory;
    const auto until = [&](const MeshShape& a, double z, double speed, double latest) {
        PairWitness witness;
        return cast_until({a, at(0, 0, z)}, Vec3(0, 0, -speed), {b, {}}, latest, memory, witness);
    };
    const MeshShape a = shape_of(needle);
    // The doubles nearest to 1/3 and 1/5 are below and above it.
    EXPECT_FALSE(until(a, 1, 3, 1 / 3.0));
    expect_contact(until(a, 1, 3, next_up(1 / 3.0)), 1 / 3.0, ClosestKind::vertex_face);
    expect_contact(until(a, 1, 5, 1 / 5.0), 1 / 5.0, ClosestKind::vertex_face);
    EXPECT_FALSE(until(a, 1, 5, next_down(1 / 5.0)));
    expect_contact(until(a, 1, 2, 0.5), 0.5, ClosestKind::vertex_face);
    EXPECT_FALSE(until(a, 1, 2, next_down(0.5)));
    EXPECT_FALSE(until(a, 1, 2, 0));
    expect_contact(until(a, 0, 2, 0), 0, ClosestKind::intersecting);
    EXPECT_FALSE(until(a, 0x1p-1074, 1, 0));
    expect_contact(until(a, 0x1p-1074, 1, 0x1p-1074), 0x1p-1074, ClosestKind::vertex_face);
    expect_contact(until(a, 0x1p-1074, 4, 0x1p-1074), 0x1p-1074, ClosestKind::vertex_face);
    EXPECT_FALSE(until(a, 0x5p-1074, 4, 0x1p-1074));

    // Two triangles: one comes down on a corner of b, from z; and one on its face, from w.
    const auto two = [](double z, double w) {
        return shape_of({{2, -1, z}, {2.25, -1, 1}, {2.25, -1.25, 1}, {0, 0, w}, {0.25, 0, 1}, {-0.25, 0, 1}});
    };
    constexpr double little = 0x1p-60;
    const Contact later = until(two(little, 0), 0.5, 1, 0.5);
    expect_contact(later, 0.5, ClosestKind::vertex_vertex);
    EXPECT_EQ(later->a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_FALSE(until(two(little, little), 0.5, 1, 0.5));
    EXPECT_EQ(until(two(little, little), 0.5, 1, next_up(0.5)), later);
    EXPECT_EQ(until(two(0, little), 0.5, 1, 0.5), later);
    EXPECT_EQ(until(two(-little, little), 0.5, 1, 0.5), later);
    EXPECT_FALSE(until(two(-little, -little), 0.5, 1, next_down(0.5)));
    expect_contact(until(two(0x1p-40, 0), 0.5, 1, 0.5), 0.5, ClosestKind::vertex_face);
}

// What a cast answers is a question again: the motion up to the contact takes all the time, and a shorter one does not
// get there.
TEST(Cast, AnswersAsArguments) {
    const MeshShape torus(scenes::torus(20, 10, 0.4)), sphere(scenes::sphere(12, 8));
    scenes::Random random(5);
    QueryMemory memory;
    int contacts = 0;
    for (int i = 0; i < 400; ++i) {
        const Pose a = at(random.uniform(4, 5), random.uniform(-1, 1), random.uniform(-1, 1));
        // Powers of two times one vector.
        const Vec3 motion(-6, random.uniform(-1, 1), random.uniform(-1, 1));
        const Contact first = cast({torus, a}, motion, {sphere, {}}, 1, memory);
        if (!first) continue;
        ++contacts;
        const double slower = std::exp2(std::ceil(std::log2(first->time)));
        const Contact part = cast({torus, a}, slower * motion, {sphere, {}}, 1, memory);
        ASSERT_TRUE(part) << i;
        EXPECT_EQ(slower * part->time, first->time);
        EXPECT_EQ(part->a, first->a);
        EXPECT_EQ(part->b, first->b);
        Pose before = a, after = a;
        before.t += first->time * (1 - 0x1p-30) * motion;
        after.t += first->time * (1 + 0x1p-30) * motion;
        EXPECT_FALSE(intersects({torus, before}, {sphere, {}}, memory));
        EXPECT_TRUE(intersects({torus, after}, {sphere, {}}, memory));
    }
    EXPECT_GT(contacts, 200);
}

// A face that comes down on a plane of many triangles: all of them are candidates, and few are asked exactly.
TEST(Cast, CandidatesOnTheSameFeaturesAreOne) {
    std::vector<Vec3> rim{{0, 0, 0}};
    std::vector<Triangle> fan;
    constexpr std::uint32_t count = 24;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * i / count;
        rim.emplace_back(std::cos(angle), std::sin(angle), 1);
        fan.push_back({0, i + 1, (i + 1) % count + 1});
    }
    const MeshShape cone(Mesh::create(rim, fan)), b = shape_of(flat);
    QueryMemory memory;
    const Contact contact = cast({cone, at(0, 0, 1)}, Vec3(0, 0, -3), {b, {}}, 1, memory);
    expect_contact(contact, 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_LE(memory.counts().casts.exact, 3u);
}

// One corner meets two faces, of which the second is so close behind the first that doubles do not know which is which.
TEST(Cast, CandidatesOnOneFeatureOfTwoAreTwo) {
    const MeshShape a = shape_of(needle);
    for (int exponent = -52; exponent <= -40; ++exponent) {
        const double behind = -std::ldexp(1.0, exponent);
        std::vector<Vec3> faces(flat);
        for (Vec3& v : faces) v[2] = behind;
        faces.insert(faces.end(), flat.begin(), flat.end());
        const MeshShape b = shape_of(faces);
        QueryMemory memory;
        const Contact contact = cast({a, at(0, 0, 1)}, Vec3(0, 0, -3), {b, {}}, 1, memory);
        expect_contact(contact, 1 / 3.0, ClosestKind::vertex_face);
        EXPECT_EQ(contact->b, (Feature{Feature::Kind::face, 1, 0})) << exponent;
    }
}

}  // namespace
}  // namespace ecods
