// Rounded bodies and half spaces beside the oracle.
#include <gtest/gtest.h>

#include <cmath>

#include "ecods/world.hpp"
#include "oracle/half_space.hpp"
#include "oracle/rounded.hpp"
#include "scenes/pose_at.hpp"
#include "unit/query/half_space_cases.hpp"

namespace ecods::half_space_rounded_test {
namespace {

using namespace half_space_cases;
using oracle::FractionAndRoot;

void expect_right(const Case& c, double radius) {
    const Rounded shape(c.shape, radius);
    const Posed<Rounded> body(shape, c.body);
    const Posed<HalfSpace> half_space(c.half_space, c.at);
    const Mesh& mesh = c.shape->mesh();
    const oracle::ExactHeights heights({c.half_space->normal(), c.half_space->offset(), c.at});
    const oracle::LowestCorner lowest = lowest_corner(heights, mesh, c.body);
    const auto& G = heights.direction();
    const mpq_class square = G[0] * G[0] + G[1] * G[1] + G[2] * G[2];
    // The distance of a height from the plane, with its sign, and a number more.
    const auto beyond = [&](const mpq_class& height, const mpq_class& more) {
        return FractionAndRoot{more, sgn(height), height * height / square};
    };
    const FractionAndRoot truth = beyond(lowest.height, -mpq_class(radius));
    const int sign = truth.sign();
    const bool has_inside = radius > 0;
    EXPECT_EQ(intersects(body, half_space), sign <= 0);
    const double signed_one = signed_distance(body, half_space).distance;
    EXPECT_EQ(signed_one, nearest(truth) == 0 ? sign * 0x1p-1074 : nearest(truth));
    EXPECT_EQ(distance(body, half_space), std::max(signed_one, 0.0));
    for (const double d : {0.0, std::abs(signed_one), std::nextafter(std::abs(signed_one), 0.0), radius}) {
        EXPECT_EQ(within(body, half_space, d), beyond(lowest.height, -mpq_class(radius) - mpq_class(d)).sign() <= 0)
            << d;
    }
    if (has_inside) {
        const bool is_inside = beyond(greatest_height(heights, mesh, c.body), mpq_class(radius)).sign() <= 0;
        EXPECT_EQ(relation(body, half_space), sign > 0    ? Relation::apart
                                              : sign == 0 ? Relation::touching
                                              : is_inside ? Relation::inside
                                                          : Relation::overlapping);
    }
    const ClosestPoints points = closest(body, half_space);
    const auto x = oracle::exact_posed(mesh.vertices()[lowest.vertex], c.body);
    EXPECT_EQ(points.distance, std::max(signed_one, 0.0));
    EXPECT_EQ(points.a, (Feature{Feature::Kind::vertex, lowest.triangle, lowest.corner}));
    if (sgn(lowest.height) <= 0) {
        EXPECT_EQ(points.kind, ClosestKind::contained);
        return;
    }
    EXPECT_EQ(signed_distance(body, half_space).point_a, points.point_a);
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        EXPECT_EQ(points.point_a[k], nearest(FractionAndRoot{x[at], -mpq_class(radius) * G[at], 1 / square})) << k;
    }
    EXPECT_EQ(points.point_b, heights.foot(mesh.vertices()[lowest.vertex], c.body).nearest());
}

TEST(HalfSpaceRounded, AsTheOracle) {
    Random random(21);
    for (int i = 0; i < 400 && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        const Case c = i % 3 == 0 ? lattice(random) : i % 3 == 1 ? general(random) : near_contact(random);
        // The last radius makes the body touch, or nearly so.
        const double radii[] = {0, 1, 0x1p-60, random.uniform(0, 3),
                                std::abs(signed_distance({c.shape, c.body}, {c.half_space, c.at}).distance)};
        expect_right(c, radii[random.below(5)]);
    }
    for (int i = 0; i < 100 && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        expect_right(i % 2 == 0 ? wide(random) : scaled(random, lattice(random)), std::ldexp(1.0, 20 * i - 1000));
    }
}

// Balls of Pythagorean centers on a tilted plane: they touch it exactly.
TEST(HalfSpaceRounded, BallsOnATiltedPlane) {
    const HalfSpace tilted(Vec3(3, 4, 0), 0);
    const auto ball = sphere(5);
    for (const double scale : {1.0, 0x1p-500, 0x1p300}) {
        const Posed<HalfSpace> plane(tilted, Pose{});
        const Rounded one(ball->core_ptr(), 5 * scale);
        EXPECT_EQ(relation({one, at(Vec3(3, 4, 7) * scale)}, plane), Relation::touching);
        EXPECT_EQ(relation({one, at(Vec3(-3, -4, 7) * scale)}, plane), Relation::inside);
        EXPECT_EQ(relation({one, at(Vec3(0, 0, 7) * scale)}, plane), Relation::overlapping);
        EXPECT_EQ(closest({one, at(Vec3(6, 8, 7) * scale)}, plane).point_a, Vec3(3, 4, 7) * scale);
    }
}

TEST(HalfSpaceRounded, Worlds) {
    World world;
    world.set_relations(true);
    world.set_clearance(0.5);
    const BodyId floor = world.create_body(std::make_shared<HalfSpace>(Vec3::UnitZ(), 0), Pose{});
    const BodyId ball = world.create_body(sphere(1), at(0, 0, 1));
    const BodyId bone = world.create_body(capsule({0, 0, 0}, {1, 0, 0}, 0.25), at(9, 0, 0.75));
    world.update();
    ASSERT_EQ(world.colliding_pairs().size(), 1u);
    EXPECT_EQ(world.relation(ball, floor), Relation::touching);
    EXPECT_EQ(world.close_pairs().size(), 2u);
    EXPECT_EQ(world.distance(floor, bone), 0.5);
    world.set_pose(ball, at(0, 0, std::nextafter(1.0, 2.0)));
    world.update();
    EXPECT_TRUE(world.colliding_pairs().empty());
    EXPECT_NO_THROW(world.check_invariants());
}

}  // namespace
}  // namespace ecods::half_space_rounded_test
