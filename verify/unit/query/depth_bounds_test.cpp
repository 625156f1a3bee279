#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/primitives.hpp"
#include "ecods/solid.hpp"
#include "environment/float_mode.hpp"
#include "scenes/convex_cases.hpp"
#include "scenes/each_case.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/solid_cases.hpp"

namespace ecods {
namespace {

bool shares_inner_points(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory) {
    const Relation relation = ecods::relation(a, b, memory);
    return relation != Relation::apart && relation != Relation::touching;
}

// What solid.hpp promises, and that no translation shorter than the lower bound parts the solids, of some.
std::optional<DepthBounds> expect_bounds(const Posed<Solid>& a, const Posed<Solid>& b, scenes::Random& random,
                                         QueryMemory& memory) {
    const Relation relation = ecods::relation(a, b, memory);
    if (relation == Relation::apart) {
        EXPECT_FALSE(depth_bounds(a, b, memory));
        return std::nullopt;
    }
    const DepthBounds bounds = depth_bounds(a, b, memory).value();
    EXPECT_LE(bounds.lower, bounds.upper);
    EXPECT_FALSE(shares_inner_points(a, {*b.what, {b.pose.R, bounds.parted}}, memory));
    // The length in long doubles, of which the last digits are some hundred times as small.
    long double square = 0;
    for (int k = 0; k < 3; ++k) {
        const long double d = static_cast<long double>(bounds.parted[k]) - b.pose.t[k];
        square += d * d;
    }
    EXPECT_GE(static_cast<long double>(bounds.upper) * (1 + 0x1p-60L), std::sqrt(square));
    if (relation == Relation::touching) {
        EXPECT_EQ(bounds.upper, 0);
        EXPECT_EQ(bounds.parted, b.pose.t);
    } else {
        EXPECT_GT(bounds.upper, 0);
        for (int i = 0; i < 10; ++i) {
            const Vec3 s = random.direction() * (bounds.lower * random.uniform(0.9, 0.999999));
            EXPECT_TRUE(shares_inner_points(a, {*b.what, {b.pose.R, b.pose.t + s}}, memory));
        }
    }
    return bounds;
}

TEST(DepthBounds, HoldForSolidsOfAnyKind) {
    QueryMemory memory;
    const auto count = [](std::string_view family) {
        constexpr std::string_view some[] = {"polycubes", "shells", "boxes", "contacts", "common pose", "bodies"};
        return std::ranges::count(some, family) != 0 ? 6 : 0;
    };
    scenes::for_each_case(scenes::solid_families(), 5, count, [&](const scenes::SolidCase& c, scenes::Random& random) {
        const Solid a(c.a.mesh), b(c.b.mesh);
        expect_bounds({a, c.a.pose}, {b, c.b.pose}, random, memory);
    });
}

TEST(DepthBounds, ContainTheDepthOfConvexSolids) {
    QueryMemory memory;
    scenes::for_each_case(scenes::convex_families(), 7, 4, [&](const scenes::ConvexCase& c) {
        const ConvexSolid a(c.a.mesh), b(c.b.mesh);
        if (a.dimension() < 3 || b.dimension() < 3) return;  // flat_solid_test.cpp
        const Solid general_a(c.a.mesh), general_b(c.b.mesh);
        const Posed<ConvexSolid> x(a, c.a.pose), y(b, c.b.pose);
        const std::optional<Depth> exact = depth(x, y, memory);
        for (const environment::FloatMode& mode : environment::float_modes) {
            SCOPED_TRACE(mode.name);
            std::optional<DepthBounds> convex, general;
            {
                const environment::InFloatMode in(mode);
                convex = depth_bounds(x, y, memory);
                general = depth_bounds({general_a, c.a.pose}, {general_b, c.b.pose}, memory);
            }
            ASSERT_EQ(convex.has_value(), exact.has_value());
            ASSERT_EQ(general.has_value(), exact.has_value());
            if (!exact) continue;
            EXPECT_LE(convex->lower, exact->depth);
            EXPECT_LE(general->lower, exact->depth);
            EXPECT_GE(convex->upper, exact->depth);
            EXPECT_GE(general->upper, exact->depth);
        }
    });
}

// Of solids a few times as large as the least double, whose sizes have no half.
TEST(DepthBounds, HoldForTheSmallestSolids) {
    QueryMemory memory;
    for (const int half : {1, 3, 13, 20}) {
        SCOPED_TRACE(half);
        std::vector<Vec3> corners;
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {-half, half}) corners.push_back(side * 0x1p-1074 * Vec3::Unit(axis));
        }
        const ConvexSolid octahedron{std::span<const Vec3>(corners)};
        const Solid general(octahedron.mesh_ptr());
        const double exact = depth({octahedron, {}}, {octahedron, {}}, memory)->depth;
        for (const environment::FloatMode& mode : environment::float_modes) {
            std::optional<DepthBounds> bounds;
            {
                const environment::InFloatMode in(mode);
                bounds = depth_bounds({general, {}}, {general, {}}, memory);
            }
            EXPECT_LE(bounds->lower, exact) << mode.name;
            EXPECT_GE(bounds->upper, exact) << mode.name;
        }
    }
}

// Not promised, but what they are for.
TEST(DepthBounds, AreNarrow) {
    QueryMemory memory;
    scenes::Random random(9);
    const Solid cube(scenes::cube(1)), torus(scenes::torus(24, 12, 0.25));
    const auto boxes = expect_bounds({cube, {}}, {cube, {Mat3::Identity(), {1.5, 0.25, 0.125}}}, random, memory);
    ASSERT_TRUE(boxes);
    EXPECT_GE(boxes->lower, 0.9 * 0.5);
    EXPECT_LE(boxes->upper, 1.001 * 0.5);
    // A ring through another one's hole, which it enters by some way.
    Mat3 upright;
    upright << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    const auto rings = expect_bounds({torus, {}}, {torus, {upright, {1.8, 0, 0}}}, random, memory);
    ASSERT_TRUE(rings);
    EXPECT_GT(rings->lower, 0.1);
    EXPECT_LE(rings->upper, 0.71);
}

// A bracket of nearly 25 km in a half space that is written as a box, however large that is: on its way out it passes
// the top of the box in the last part of a way as long as the box is.
TEST(DepthBounds, AreNarrowBesideABoxOfAnySize) {
    const std::array<Vec2, 6> outline{Vec2(0, -25000),    Vec2(3000, -25000), Vec2(3000, -12000),
                                      Vec2(1000, -12000), Vec2(1000, 5000),   Vec2(0, 5000)};
    std::vector<Vec3> corners;
    for (const double y : {0.0, 2000.0}) {
        for (const Vec2& p : outline) corners.emplace_back(p[0], y, p[1]);
    }
    std::vector<Triangle> triangles;
    for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4}, Triangle{0, 4, 5}}) {
        triangles.push_back(t);
        triangles.push_back({t[0] + 6, t[2] + 6, t[1] + 6});
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t j = (i + 1) % 6;
        triangles.push_back({i, i + 6, j});
        triangles.push_back({j, i + 6, j + 6});
    }
    const Solid bracket(Mesh::create(corners, triangles));
    scenes::Random random(31);
    QueryMemory memory;
    for (const double half : {1e5, 1e22, 3.40282347e38, 1e100, 1e300}) {
        const Solid ground(scenes::mapped(
            *scenes::cube(1), [&](const Vec3& v) { return Vec3(v[0] * half, v[1] * half, v[2] > 0 ? -100 : -half); }));
        for (int turn = 0; turn < 2; ++turn) {
            Pose pose;
            if (turn > 0) pose.R = random.rotation().toRotationMatrix();
            for (const bool is_ground_second : {false, true}) {
                SCOPED_TRACE(testing::Message() << half << ' ' << turn << ' ' << is_ground_second);
                const Solid &a = is_ground_second ? bracket : ground, &b = is_ground_second ? ground : bracket;
                const DepthBounds bounds = depth_bounds({a, pose}, {b, pose}, memory).value();
                EXPECT_FALSE(shares_inner_points({a, pose}, {b, {pose.R, bounds.parted}}, memory));
                EXPECT_LE(bounds.upper, 24900 * (1 + 0x1p-45)) << bounds.upper - 24900;
                EXPECT_GT(bounds.lower, 24899);
            }
        }
    }
}

TEST(DepthBounds, AreRefusedWithReason) {
    QueryMemory memory;
    const Solid cube(scenes::cube(1));
    Pose flat;
    flat.R.col(1).setZero();
    for (const int argument : {0, 1}) {
        try {
            std::ignore =
                depth_bounds({cube, argument == 0 ? flat : Pose()}, {cube, argument == 0 ? Pose() : flat}, memory);
            FAIL();
        } catch (const SingularPose& e) {
            EXPECT_EQ(e.argument, argument);
        }
    }
    EXPECT_FALSE(depth_bounds({cube, {}}, {cube, {Mat3::Identity(), {3, 0, 0}}}, memory));
}

}  // namespace
}  // namespace ecods
