// A world with rounded bodies: signed distances and depths of two, hits of lines, and casts.
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

using ShapePtr = std::shared_ptr<const Shape>;

TEST(RoundedWorldPairs, SignedDistancesAndDepthsAsOfTheTwoBodies) {
    World world;
    const auto box = std::make_shared<const ConvexSolid>(scenes::cube(1));
    const auto ball = sphere(0.25);
    const Pose inside = at(0.5, 0.25, 0);
    const BodyId first = world.create_body(ShapePtr(ball), inside), second = world.create_body(ShapePtr(box), Pose());
    const SignedDistance expected = signed_distance({ball, inside}, Posed<MeshShape>(box, Pose()));
    EXPECT_EQ(world.signed_distance(first, second), expected);
    const SignedDistance turned = world.signed_distance(second, first);
    EXPECT_EQ(turned.point_a, expected.point_b);
    EXPECT_EQ(turned.direction, Vec3(1, 0, 0));
    EXPECT_EQ(world.depth(first, second), depth({ball, inside}, Posed<MeshShape>(box, Pose())));
    EXPECT_EQ(world.depth(second, first)->direction, turned.direction);
    const auto soup = std::make_shared<const MeshShape>(scenes::torus(9, 5, 0.25));
    const BodyId ring = world.create_body(ShapePtr(rounded(soup, 1)), at(5));
    EXPECT_THROW((void)world.depth(ring, first), NotSupported);
    EXPECT_EQ(world.signed_distance(ring, first), signed_distance({rounded(soup, 1), at(5)}, {ball, inside}));
}

TEST(RoundedWorldPairs, HitsAndCasts) {
    World world;
    const auto box = std::make_shared<const ConvexSolid>(scenes::cube(1));
    const BodyId ball = world.create_body(ShapePtr(sphere(5)), Pose());
    const BodyId cube = world.create_body(ShapePtr(box), at(20, 3, 0));
    const BodyId padded = world.create_body(ShapePtr(rounded(box, 1)), at(40, 3, 0));
    const BodyId ground = world.create_body(ShapePtr(std::make_shared<const HalfSpace>(Vec3::UnitZ(), -50)), Pose());
    world.update();
    const Ray ray{{-9, 3, 0}, {1, 0, 0}};
    const auto first = world.first_hit(ray);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->body, ball);
    EXPECT_EQ(first->hit.parameter, 5);
    std::vector<std::pair<BodyId, double>> all;
    for (const BodyHit& hit : world.all_hits(ray)) {
        if (all.empty() || all.back() != std::pair(hit.body, hit.hit.parameter)) {
            all.push_back({hit.body, hit.hit.parameter});
        }
    }
    EXPECT_EQ(all, (std::vector<std::pair<BodyId, double>>{
                       {ball, 5}, {ball, 13}, {cube, 28}, {cube, 30}, {padded, 47}, {padded, 51}}));
    EXPECT_EQ(world.first_hit(Ray{{40, 3, 0}, {1, 0, 0}})->hit.kind, HitKind::inside);
    // A sphere of the radius 1 that is cast: at 5 + 1 from the ball; 1 and 1 from the padded cube.
    const auto sphere_cast = [&](const Vec3& from, const Vec3& motion) {
        return world.cast({sphere(1), at(from)}, motion);
    };
    EXPECT_EQ(sphere_cast({-10, 0, 0}, {8, 0, 0})->body, ball);
    EXPECT_EQ(sphere_cast({-10, 0, 0}, {8, 0, 0})->contact.time, 0.5);
    EXPECT_EQ(sphere_cast({30, 3, 0}, {14, 0, 0})->body, padded);
    EXPECT_EQ(sphere_cast({30, 3, 0}, {14, 0, 0})->contact.time, 0.5);
    EXPECT_EQ(sphere_cast({30, 3, 0}, {-16, 0, 0})->body, cube);
    EXPECT_EQ(sphere_cast({30, 3, 0}, {-16, 0, 0})->contact.time, 0.5);
    EXPECT_EQ(sphere_cast({0, 0, -9}, {0, 0, -80})->body, ground);
    EXPECT_EQ(sphere_cast({0, 0, -9}, {0, 0, -80})->contact.time, 0.5);
    EXPECT_EQ(world.cast(cube, Vec3(40, 0, 0))->body, padded);
    EXPECT_EQ(world.cast(cube, Vec3(40, 0, 0))->contact,
              *cast(Posed<MeshShape>(box, at(20, 3, 0)), Vec3(40, 0, 0), {rounded(box, 1), at(40, 3, 0)}));
    EXPECT_FALSE(sphere_cast({30, 9, 0}, {0, 8, 0}));
}

}  // namespace
}  // namespace ecods
