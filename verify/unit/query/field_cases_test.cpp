// Cases that users of other libraries have reported, with numbers of our own, asked about bodies of all kinds that such
// bodies may be made of. Each answer is derived beside it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "ecods/ecods.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

using Points = std::vector<Vec3>;

std::shared_ptr<const Mesh> box_mesh(const Vec3& low, const Vec3& high) {
    Points corners;
    for (int k = 0; k < 8; ++k) {
        corners.emplace_back((k & 1) != 0 ? high[0] : low[0], (k & 2) != 0 ? high[1] : low[1],
                             (k & 4) != 0 ? high[2] : low[2]);
    }
    return convex_hull(corners);
}
std::shared_ptr<const ConvexSolid> solid_box(const Vec3& low, const Vec3& high) {
    return std::make_shared<const ConvexSolid>(box_mesh(low, high));
}

// A box in another one: solids collide, surfaces are apart; a rounded body is a solid.
TEST(FieldCases, ABoxInsideABoxCollides) {
    const auto large = box_mesh({-4, -4, -4}, {4, 4, 4}), small = box_mesh({-1, -1, -1}, {1, 1, 1});
    const Pose beside = at(2.5, 0, 0);  // 0.5 from the nearest side
    const MeshShape skin_of_large(large), skin_of_small(small);
    const ConvexSolid all_of_large(large), all_of_small(small);
    EXPECT_FALSE(intersects({skin_of_large, Pose()}, {skin_of_small, beside}));
    EXPECT_EQ(distance({skin_of_large, Pose()}, {skin_of_small, beside}), 0.5);
    EXPECT_TRUE(intersects({all_of_large, Pose()}, {skin_of_small, beside}));
    EXPECT_EQ(distance({all_of_large, Pose()}, {all_of_small, beside}), 0);
    EXPECT_EQ(relation({all_of_small, beside}, {all_of_large, Pose()}), Relation::inside);
    EXPECT_EQ(signed_distance(Posed<ConvexSolid>{all_of_large, Pose()}, {all_of_small, beside}).distance, -2.5)
        << "out by the nearest side: 0.5 less than its own width of 2 more";
    const auto ball = sphere(1), margin = rounded(std::make_shared<const MeshShape>(large), 0.25);
    EXPECT_TRUE(intersects({ball, beside}, Posed<MeshShape>(all_of_large, Pose())));
    EXPECT_FALSE(intersects({ball, beside}, Posed<MeshShape>(skin_of_large, Pose())));
    EXPECT_EQ(distance({ball, beside}, {margin, Pose()}), 0.25) << "a margin around a surface leaves its hollow";
    World world;
    const BodyId a = world.create_body(std::make_shared<const ConvexSolid>(large), Pose());
    const BodyId b = world.create_body(sphere(1), beside);
    world.update();
    ASSERT_EQ(world.colliding_pairs().size(), 1U);
    EXPECT_EQ(world.signed_distance(a, b).distance, -2.5);
    EXPECT_EQ(world.closest_pair()->distance, -2.5);
}

// A program wrote a half space as an enormous box. The L reaches 700 below the top at z = -40; no other way out is
// short.
TEST(FieldCases, AHalfSpaceAndABoxOfItsSize) {
    const Points outline{{0, 0, -740}, {90, 0, -740}, {90, 0, -500}, {30, 0, -500}, {30, 0, 60}, {0, 0, 60}};
    Points corners = outline;
    for (const Vec3& p : outline) corners.emplace_back(p[0], 50, p[2]);
    std::vector<Triangle> faces;
    for (const Triangle& t : {Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{0, 3, 5}, Triangle{3, 4, 5}}) {
        faces.push_back(t);
        faces.push_back({t[0] + 6, t[2] + 6, t[1] + 6});
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t next = (i + 1) % 6;
        faces.push_back({i, i + 6, next});
        faces.push_back({next, i + 6, next + 6});
    }
    const auto mesh = Mesh::create(std::move(corners), std::move(faces));
    const Solid bracket(mesh);
    const HalfSpace below(Vec3::UnitZ(), -40);
    const SignedDistance exact = signed_distance({bracket, Pose()}, {below, Pose()});
    EXPECT_EQ(exact.distance, -700);
    EXPECT_EQ(relation({bracket, Pose()}, {below, Pose()}), Relation::overlapping);
    const auto with_margin = rounded(std::make_shared<const Solid>(mesh), 0.5);
    EXPECT_EQ(signed_distance({with_margin, Pose()}, {below, Pose()}).distance, -700.5);
    for (const double size : {1e20, 0x1p120, 1e300}) {
        const Solid box(box_mesh({-size, -size, -size}, {size, size, -40}));
        const auto bounds = depth_bounds(Posed<Solid>{bracket, Pose()}, {box, Pose()});
        ASSERT_TRUE(bounds.has_value());
        EXPECT_LE(bounds->lower, 700);
        EXPECT_GE(bounds->upper, 700);
        EXPECT_LE(bounds->upper, 700 * (1 + 0x1p-40)) << size;
    }
}

// A pipe goes 1/8 deep into a wall of 1/4: along y it leaves after 1/8 + 1/4 at the other side, or 1/8 back.
TEST(FieldCases, ADuctInAWall) {
    const auto wall = solid_box({-3, -0.125, 0}, {3, 0.125, 2}), duct = solid_box({-0.25, -2, 0.75}, {0.25, 0, 1.25});
    const Posed<ConvexSolid> a(wall, Pose()), b(duct, Pose());
    EXPECT_EQ(depth(a, b)->depth, 0.125);
    EXPECT_EQ(depth_along(a, b, Vec3(0, -1, 0))->length, 0.125);
    EXPECT_EQ(depth_along(a, b, Vec3(0, 1, 0))->length, 2.125);
    EXPECT_EQ(depth_along(a, b, Vec3(0, 0, 4))->parameter, 1.25 / 4);
    const auto round_duct = capsule({0, -2, 1}, {0, -0.25, 1}, 0.25);  // to y = 0, too
    EXPECT_EQ(depth(Posed<MeshShape>(a), Posed<Rounded>(round_duct, Pose()))->depth, 0.125);
}

// The roof is a gable roof from x = 0 to x = 8, with its ridge at y = 2 and z = 4.
TEST(FieldCases, PartsOfSegmentsInARoof) {
    const ConvexSolid roof(Points{{0, 0, 0}, {8, 0, 0}, {0, 4, 0}, {8, 4, 0}, {0, 2, 4}, {8, 2, 4}});
    const auto parts = [&](const Vec3& from, const Vec3& to) {
        return inside_parts(Segment{from, to}, Posed<Solid>(roof, Pose()));
    };
    const auto through = parts({-8, 2, 1}, {24, 2, 1});
    ASSERT_EQ(through.size(), 1U);
    EXPECT_EQ(through[0].from, 0.25);
    EXPECT_EQ(through[0].to, 0.5);
    EXPECT_TRUE(parts({-8, 2, 4}, {24, 2, 4}).empty()) << "along the ridge";
    EXPECT_TRUE(parts({4, -4, 4}, {4, 8, 4}).empty()) << "across the ridge";
    const auto out = parts({4, 2, 3}, {4, 2, 7});
    ASSERT_EQ(out.size(), 1U);
    EXPECT_EQ(out[0].from, 0);
    EXPECT_EQ(out[0].to, 0.25);
}

// Points, segments and triangles without an area, as surfaces, as flat solids and with radii.
TEST(FieldCases, BodiesWithoutAnArea) {
    const auto line = Mesh::create({Vec3(0, 0, 0), Vec3(4, 2, 0), Vec3(8, 4, 0)}, {Triangle{0, 1, 2}});
    const Vec3 point(3, 4, 0);  // (8, 4) x (3, 4) = 20, over the length of sqrt(80): 5 / sqrt(5)
    EXPECT_EQ(closest(point, Posed<MeshShape>(std::make_shared<const MeshShape>(line), Pose())).distance,
              std::sqrt(5.0));
    EXPECT_EQ(closest(point, Posed<MeshShape>(std::make_shared<const ConvexSolid>(line), Pose())).distance,
              std::sqrt(5.0));
    const auto ball = sphere(5, point), dot = sphere(0, {0, 0, 0});
    EXPECT_EQ(distance({ball, Pose()}, {dot, Pose()}), 0) << "3, 4, 5";
    EXPECT_EQ(relation({ball, Pose()}, {dot, Pose()}), Relation::touching);
    // Two segments in one plane: (0, 0)..(2, 0) goes along (4, 0) and meets (3, -1)..(3, 1) after 1.
    const auto first = std::make_shared<const ConvexSolid>(Points{{0, 0, 0}, {2, 0, 0}});
    const auto second = std::make_shared<const ConvexSolid>(Points{{3, -1, 0}, {3, 1, 0}});
    EXPECT_EQ(cast(Posed<MeshShape>(first, Pose()), {4, 0, 0}, Posed<MeshShape>(second, Pose()))->time, 0.25);
    const auto thick = capsule({0, 0, 0}, {2, 0, 0}, 0.5);
    EXPECT_EQ(cast(Posed<Rounded>(thick, Pose()), {4, 0, 0}, Posed<MeshShape>(second, Pose()))->time, 0.125);
}

// A body that lies on a floor touches it, and meets it at time 0 by every motion; a solid enters the floor by one of
// the motions only.
TEST(FieldCases, WhatRestsOnAFloor) {
    const auto floor = solid_box({-9, -9, -1}, {9, 9, 0}), cube = solid_box({0, 0, 0}, {1, 1, 1});
    const auto ball = sphere(0.5, {0.5, 0.5, 0.5});
    const HalfSpace ground(Vec3::UnitZ(), 0);
    const Posed<MeshShape> on(cube, Pose()), under(floor, Pose());
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        EXPECT_EQ(cast(on, way, under)->time, 0);
        EXPECT_EQ(cast(Posed<Rounded>(ball, Pose()), way, under)->time, 0);
        EXPECT_EQ(cast(Posed<Rounded>(ball, Pose()), way, {ground, Pose()})->time, 0);
        EXPECT_EQ(entering(on, way, under).has_value(), way[2] < 0);
    }
    EXPECT_EQ(relation(on, under), Relation::touching);
    EXPECT_EQ(relation({ball, Pose()}, under), Relation::touching);
    EXPECT_EQ(relation({ball, Pose()}, {ground, Pose()}), Relation::touching);
    // To within 3/4 of the floor, from 4 above.
    const Pose above = at(0, 0, 4);
    EXPECT_EQ(cast_to_distance({cube, above}, {0, 0, -4}, under, 0.75)->time, 3.25 / 4);
    EXPECT_EQ(cast_to_distance(Posed<Rounded>(ball, above), {0, 0, -4}, under, 0.75)->time, 3.25 / 4);
}

// Depths of one step of a float: 2^-20 at 8, and 2^-9 at 2^14. A tolerance is the caller's: the depths are exact.
TEST(FieldCases, FlushInFloats) {
    for (const auto& [place, step] : {std::pair(8.0, 0x1p-20), std::pair(0x1p14, 0x1p-9)}) {
        const auto left = solid_box({place - 1, 0, 0}, {place + step, 1, 1});
        const auto right = solid_box({place, 0, 0}, {place + 1, 1, 1});
        EXPECT_EQ(signed_distance(Posed<ConvexSolid>{left, Pose()}, Posed<ConvexSolid>{right, Pose()}).distance, -step);
        const auto a = capsule({place - 1, 0, 0}, {place + step - 0.5, 0, 0}, 0.5);
        const auto b = sphere(0.5, {place + 0.5, 0, 0});
        EXPECT_EQ(signed_distance(Posed<Rounded>(a, Pose()), Posed<Rounded>(b, Pose())).distance, -step);
        EXPECT_EQ(relation({a, Pose()}, Posed<Rounded>(b, Pose())), Relation::overlapping);
    }
}

}  // namespace
}  // namespace ecods
