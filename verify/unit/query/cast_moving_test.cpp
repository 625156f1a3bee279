// First contacts of bodies on their way between poses, with times that are known: in each kind of features, in one
// plane or on one line throughout, grazing, at both ends of time, between doubles, at any scale.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <tuple>

#include "ecods/cast.hpp"
#include "ecods/intersection.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/cast_bodies.hpp"

namespace ecods {
namespace {

Pose turned(const Mat3& R, const Vec3& t = Vec3::Zero()) {
    Pose pose;
    pose.R = R;
    pose.t = t;
    return pose;
}

// A body moves, the other is at the origin of its mesh.
std::optional<FirstContact> cast_at(const MeshShape& a, const Pose& from, const Pose& to, const MeshShape& b) {
    QueryMemory memory;
    const Pose rest;
    const auto contact = cast(Moving<MeshShape>(a, from, to), Moving<MeshShape>(b, rest, rest), 1, memory);
    const auto other = cast(Moving<MeshShape>(b, rest, rest), Moving<MeshShape>(a, from, to), 1, memory);
    EXPECT_EQ(contact.has_value(), other.has_value());
    if (contact && other) {
        EXPECT_EQ(contact->time, other->time);
        EXPECT_EQ(contact->kind, other->kind);
    }
    return contact;
}

TEST(CastMoving, VertexMeetsFace) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    const auto contact = cast_at(a, at(0, 0, 1), at(0, 0, -2), b);
    expect_contact(contact, 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(contact->b, (Feature{Feature::Kind::face, 0, 0}));
}

TEST(CastMoving, VertexMeetsEdgeAndVertex) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    expect_contact(cast_at(a, at(0, -1, 1), at(0, -1, -6), b), 1 / 7.0, ClosestKind::vertex_edge);
    expect_contact(cast_at(a, at(2, -1, 1), at(2, -1, -6), b), 1 / 7.0, ClosestKind::vertex_vertex);
}

TEST(CastMoving, EdgesCross) {
    const MeshShape a = shape_of({{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}), b = shape_of({{0, -1, 0}, {0, 1, 0}, {0, 0, -1}});
    const auto contact = cast_at(a, at(0, 0, 1), at(0, 0, -2), b);
    expect_contact(contact, 1 / 3.0, ClosestKind::edge_edge);
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::edge, 0, 0}));
    EXPECT_EQ(contact->b, (Feature{Feature::Kind::edge, 0, 0}));
}

TEST(CastMoving, ContactAtBothEnds) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    expect_contact(cast_at(a, at(0, 0, 1), at(0, 0, 0), b), 1, ClosestKind::vertex_face);
    EXPECT_FALSE(cast_at(a, at(0, 0, 1), at(0, 0, 0x1p-60), b));
    expect_contact(cast_at(a, at(0, 0, 0), at(0, 0, 1), b), 0, ClosestKind::intersecting);
    expect_contact(cast_at(a, at(0, 0, -0.5), at(0, 0, 3), b), 0, ClosestKind::intersecting);
    // A positive time is positive, however small: here 2^-1100, and a little less than 3 * 2^-1075, which is half-way
    // between two doubles.
    expect_contact(cast_at(a, at(0, 0, 0x1p-100), at(0, 0, -0x1p1000), b), 0x1p-1074, ClosestKind::vertex_face);
    expect_contact(cast_at(a, at(0, 0, 0x3p-1074), at(0, 0, -2), b), 0x1p-1074, ClosestKind::vertex_face);
}

TEST(CastMoving, BodiesAtRest) {
    const MeshShape a = shape_of(needle), b = shape_of(flat);
    EXPECT_FALSE(cast_at(a, at(0, 0, 0x1p-1074), at(0, 0, 0x1p-1074), b));
    expect_contact(cast_at(a, at(0, 0, 0), at(0, 0, -0.0), b), 0, ClosestKind::intersecting);
}

// A vertex touches a face and goes back: the height is quadratic only where the face turns, so it does.
TEST(CastMoving, Grazes) {
    // The corner is at (s, 0, h); the face z = s x - ... turns such that the corner's height over it is (1 - 2 s)^2
    // / 4.
    const MeshShape corner = shape_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    const MeshShape face = shape_of({{-8, -8, 0}, {8, -8, 0}, {0, 8, 0}});
    Mat3 end = Mat3::Identity();
    end(2, 0) = -1;  // z = -s x at time s
    for (const double lift : {0.0, 0x1p-70, -0x1p-70}) {
        QueryMemory memory;
        // At (s, 0, 1/4 - s + lift): over the face by 1/4 - s + s^2 + lift.
        const Moving<MeshShape> a(corner, at(0, 0, 0.25 + lift), at(1, 0, -0.75 + lift));
        const auto contact = cast(a, Moving<MeshShape>(face, Pose(), turned(end)), 1, memory);
        const bool is_rounded_away = 0.25 + lift == 0.25;
        if (lift <= 0 || is_rounded_away) expect_contact(contact, 0.5, ClosestKind::vertex_face);
    }
    QueryMemory memory;
    const Moving<MeshShape> above(corner, at(0, 0, 0.25 + 0x1p-50), at(1, 0, -0.75 + 0x1p-50));
    EXPECT_FALSE(cast(above, Moving<MeshShape>(face, Pose(), turned(end)), 1, memory));
    const Moving<MeshShape> below(corner, at(0, 0, 0.25 - 0x1p-50), at(1, 0, -0.75 - 0x1p-50));
    expect_contact(cast(below, Moving<MeshShape>(face, Pose(), turned(end)), 1, memory), 0.5 - 0x1p-25,
                   ClosestKind::vertex_face);
}

// sqrt(2) - 1: x^2 + 2 x - 1 = 0.
TEST(CastMoving, IrrationalTimes) {
    const MeshShape corner = shape_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    const MeshShape face = shape_of({{-8, -8, 0}, {8, -8, 0}, {0, 8, 0}});
    Mat3 end = Mat3::Identity();
    end(2, 0) = -1;
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        QueryMemory memory;
        std::fesetround(mode);
        // At (-s, 0, 1 - 2 s) over z = s^2.
        const auto contact = cast(Moving<MeshShape>(corner, at(0, 0, 1), at(-1, 0, -1)),
                                  Moving<MeshShape>(face, Pose(), turned(end)), 1, memory);
        std::fesetround(FE_TONEAREST);
        expect_contact(contact, 0x1.a827999fcef32p-2, ClosestKind::vertex_face);
    }
}

// Both in the plane z = 0 all the time, and in one that turns.
TEST(CastMoving, InOnePlane) {
    const MeshShape a = shape_of({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}}),
                    b = shape_of({{0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}});
    expect_contact(cast_at(a, at(1, 0, 0), at(-2, 0, 0), b), 1 / 3.0, ClosestKind::vertex_vertex);
    expect_contact(cast_at(a, at(1, 0.5, 0), at(-6, 0.5, 0), b), 3 / 14.0, ClosestKind::vertex_edge);
    EXPECT_FALSE(cast_at(a, at(1, 3, 0), at(-2, 3, 0), b));
    Mat3 tilted = Mat3::Identity();
    tilted(2, 0) = 1;
    tilted(2, 1) = 2;
    QueryMemory memory;
    Pose a_end = turned(tilted), b_end = turned(tilted);
    a_end.t = tilted * Vec3(-2, 0, 0);
    const auto contact = cast(Moving<MeshShape>(a, at(1, 0, 0), a_end), Moving<MeshShape>(b, Pose(), b_end), 1, memory);
    ASSERT_TRUE(contact);
}

// Zero-area triangles on one line all the time, and points.
TEST(CastMoving, OnOneLine) {
    const MeshShape a = shape_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), b = shape_of({{0, 0, 0}, {-1, 0, 0}, {-2, 0, 0}});
    expect_contact(cast_at(a, at(1, 0, 0), at(-9, 0, 0), b), 0.1, ClosestKind::vertex_vertex);
    const MeshShape point = shape_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    expect_contact(cast_at(point, at(1, 0, 0), at(-9, 0, 0), b), 0.1, ClosestKind::vertex_vertex);
    expect_contact(cast_at(point, at(1, 1, 1), at(-9, -9, -9), point), 0.1, ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_at(point, at(1, 1, 1), at(-9, -9, -8), point));
    expect_contact(cast_at(point, at(-1, 0, 1), at(-1, 0, -9), b), 0.1, ClosestKind::vertex_vertex);
    expect_contact(cast_at(point, at(-0.5, 0, 1), at(-0.5, 0, -9), b), 0.1, ClosestKind::vertex_edge);
}

// Half a turn: all points pass through the axis at once, half-way. What is there is a segment.
TEST(CastMoving, FlatHalfWay) {
    const MeshShape a = shape_of({{1, 1, 0}, {3, 1, 0}, {2, 1, 3}});
    const MeshShape b = shape_of({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
    const Mat3 half_turn = Vec3(-1, -1, 1).asDiagonal();
    const auto contact = cast_at(a, Pose(), turned(half_turn), b);
    expect_contact(contact, 0.5, ClosestKind::vertex_edge);
    // Edges 1 and 2 both hold it.
    EXPECT_EQ(contact->a.corner, 1u);
    // A point that is on the axis but above it.
    const MeshShape c = shape_of({{0, 0, 4}, {0, 0, 4}, {0, 0, 4}});
    EXPECT_FALSE(cast_at(a, Pose(), turned(half_turn), c));
    // Inverted: all is in one point.
    const MeshShape origin = shape_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    expect_contact(cast_at(a, Pose(), turned(-Mat3::Identity()), origin), 0.5, ClosestKind::vertex_vertex);
}

TEST(CastMoving, AnyScale) {
    for (const int exponent : {-1000, -900, -300, 300, 900}) {
        const double scale = std::ldexp(1.0, exponent);
        const MeshShape a = shape_of(needle), b = shape_of(flat);
        const Mat3 R = Mat3::Identity() * scale;
        QueryMemory memory;
        const auto contact = cast(Moving<MeshShape>(a, turned(R, {0, 0, scale}), turned(R, {0, 0, -2 * scale})),
                                  Moving<MeshShape>(b, turned(R), turned(R)), 1, memory);
        expect_contact(contact, 1 / 3.0, ClosestKind::vertex_face);
    }
}

// The poses of time s, which are doubles.
Pose between(const Moving<MeshShape>& body, double s) {
    return turned((1 - s) * body.from.R + s * body.to.R, (1 - s) * body.from.t + s * body.to.t);
}

// Lattice bodies at 64 moments: they are apart before the first contact.
TEST(CastMoving, AgreesWithSamples) {
    scenes::Random random(3);
    const auto number = [&] { return static_cast<double>(random.below(9)) - 4; };
    const auto pose = [&] {
        Pose result;
        for (int i = 0; i < 9; ++i) result.R.data()[i] = static_cast<double>(random.below(5)) / 2 - 1;
        result.t = {2 * number(), number(), number()};
        return result;
    };
    int hits = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<Vec3> u, v;
        for (int i = 0; i < 6; ++i) u.push_back({number(), number(), number()});
        for (int i = 0; i < 6; ++i) v.push_back({number(), number(), number()});
        const MeshShape a = shape_of(u), b = shape_of(v);
        const Moving<MeshShape> from_a(a, pose(), pose()), from_b(b, pose(), pose());
        QueryMemory memory;
        const auto contact = cast(from_a, from_b, 1, memory);
        hits += contact.has_value();
        for (int i = 0; i <= 64; ++i) {
            const double s = i / 64.0;
            const bool meet =
                intersects(Posed<MeshShape>(a, between(from_a, s)), Posed<MeshShape>(b, between(from_b, s)), memory);
            ASSERT_TRUE(!meet || (contact && contact->time <= s)) << round << ' ' << s;
            ASSERT_TRUE(meet || !contact || contact->time != s) << round << ' ' << s;
        }
    }
    EXPECT_GT(hits, 1000);
}

// The same answer with a witness of any kind, and from memory that other questions used.
TEST(CastMoving, WitnessChangesNothing) {
    scenes::Random random(4);
    const MeshShape torus(scenes::torus(24, 12, 0.4));
    QueryMemory used;
    PairWitness witness;
    for (int round = 0; round < 60; ++round) {
        const auto pose = [&](double distance) {
            return Pose::from_quaternion(random.rotation(), random.direction() * distance);
        };
        const Moving<MeshShape> a(torus, pose(0), pose(0.5)), b(torus, pose(4), pose(round % 3 == 0 ? 4.0 : 0.5));
        QueryMemory fresh;
        const auto expected = cast(a, b, 1, fresh);
        EXPECT_EQ(cast(a, b, 1, used), expected);
        PairWitness any{random.below(600), random.below(600)};
        EXPECT_EQ(cast(a, b, 1, {used, any}), expected);
        EXPECT_EQ(cast(a, b, 1, {used, witness}), expected);
        EXPECT_EQ(cast(a, b, 1, {used, witness}), expected);
    }
}

// Of the pairs of triangles that boxes leave over, doubles decide nearly all.
TEST(CastMoving, FewPairsAreDecidedExactly) {
    scenes::Random random(5);
    const MeshShape torus(scenes::torus(64, 32, 0.4));
    QueryMemory memory;
    for (int round = 0; round < 40; ++round) {
        const Pose from = Pose::from_quaternion(random.rotation(), random.direction() * 4),
                   to = Pose::from_quaternion(random.rotation(), random.direction());
        const Pose rest = Pose::from_quaternion(random.rotation(), Vec3::Zero());
        std::ignore = cast(Moving<MeshShape>(torus, from, to), Moving<MeshShape>(torus, rest, rest), 1, memory);
    }
    EXPECT_LE(memory.counts().casts.exact, 12u * 40);
    EXPECT_EQ(memory.counts().queries, 40u);
}

}  // namespace
}  // namespace ecods
