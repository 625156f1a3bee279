// Points and rounded bodies: known answers, and the oracle.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/rounded_bodies.hpp"

namespace ecods {
namespace {

using rounded_bodies::around;
using rounded_bodies::Ball;

TEST(RoundedPoints, OfABall) {
    const Ball ball = sphere(7, {1, 0, 0});
    const Posed<Rounded> body(ball, Pose());
    const Vec3 on(3, 3, 6), inside(3, 3, std::nextafter(6.0, 0)), outside(3, 3, std::nextafter(6.0, 7));
    EXPECT_EQ(signed_distance(on, body), 0);
    EXPECT_EQ(locate(on, body), (Location{Side::on, {Feature::Kind::vertex, 0, 0}}));
    EXPECT_EQ(closest(on, body), (ClosestPoint{0, {Feature::Kind::vertex, 0, 0}, on}));
    EXPECT_LT(signed_distance(inside, body), 0);
    EXPECT_EQ(locate(inside, body), (Location{Side::inside, {}}));
    EXPECT_EQ(closest(inside, body), (ClosestPoint{0, no_feature, inside}));
    EXPECT_GT(signed_distance(outside, body), 0);
    EXPECT_EQ(locate(outside, body).side, Side::outside);
    EXPECT_EQ(closest(Vec3(5, 6, 12), body), (ClosestPoint{7, {Feature::Kind::vertex, 0, 0}, on}));
    EXPECT_EQ(signed_distance(Vec3(1, 0, 0), body), -7);
}

TEST(RoundedPoints, OfASolidWithAMargin) {
    const auto box = std::make_shared<const ConvexSolid>(scenes::cube(1));
    const Ball padded = rounded(box, 0.5), shell = rounded(surface_of(*box), 0.5), bare = rounded(box, 0);
    EXPECT_EQ(signed_distance(Vec3(0.25, 0, 0), {padded, Pose()}), -1.25);
    EXPECT_EQ(signed_distance(Vec3(0.25, 0, 0), {shell, Pose()}), 0.25) << "a surface has no inside";
    EXPECT_EQ(signed_distance(Vec3(0.75, 0, 0), {shell, Pose()}), -0.25);
    EXPECT_EQ(signed_distance(Vec3(1, 0, 0), {padded, Pose()}), -0.5);
    EXPECT_EQ(signed_distance(Vec3(4, 5, 0), {padded, Pose()}), 4.5);
    EXPECT_EQ(closest(Vec3(4, 5, 0), {padded, Pose()}).point, Vec3(1.3, 1.4, 0));
    EXPECT_EQ(closest(Vec3(4, 5, 0), {padded, Pose()}).feature.kind, Feature::Kind::edge);
    EXPECT_EQ(locate(Vec3(0.25, 0, 0), {padded, Pose()}).side, Side::inside);
    EXPECT_EQ(locate(Vec3(0.5, 0, 0), {shell, Pose()}).side, Side::on);
    EXPECT_EQ(locate(Vec3(0.5, 0, 0), {bare, Pose()}).side, Side::inside);
    EXPECT_EQ(locate(Vec3(1, 0, 0), {bare, Pose()}), locate(Vec3(1, 0, 0), {*box, Pose()}));
    EXPECT_EQ(signed_distance(Vec3(0.5, 0, 0), {bare, Pose()}), -0.5);
    EXPECT_EQ(closest(Vec3(0.5, 0, 0), {bare, Pose()}), closest(Vec3(0.5, 0, 0), Posed<MeshShape>(box, Pose())));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)signed_distance(Vec3(0, nan, 0), {padded, Pose()}), InvalidArgument);
    EXPECT_THROW((void)closest(Vec3(0, nan, 0), {padded, Pose()}), InvalidArgument);
    EXPECT_THROW((void)locate(Vec3(0, nan, 0), {bare, Pose()}), InvalidArgument);
}

TEST(RoundedPoints, AsTheOracle) {
    scenes::Random random(21);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const double unit = i % 4 == 0 ? 0x1p-1060 : i % 4 == 1 ? 0x1p990 : 1;
        const auto point = [&] { return Vec3(unit * random.direction() * random.uniform(0, 3)); };
        const Ball body = around(scenes::one_triangle({point(), point(), point()}), unit * random.uniform(0, 2));
        const Vec3 p = point();
        const Pose pose = random.turned();
        const auto cores = rounded_bodies::closest_of_cores({sphere(0, p), Pose()}, {body, pose});
        const oracle::RoundedDistance truth(cores, 0, body->radius());
        EXPECT_EQ(signed_distance(p, {body, pose}), truth.signed_distance());
        const int sign = truth.compare(0);
        EXPECT_EQ(locate(p, {body, pose}).side, sign > 0 ? Side::outside : sign < 0 ? Side::inside : Side::on);
        const ClosestPoint found = closest(p, {body, pose});
        EXPECT_EQ(found.distance, truth.distance());
        EXPECT_EQ(found.point, sign > 0 ? truth.point(1) : p);
    }
}

}  // namespace
}  // namespace ecods
