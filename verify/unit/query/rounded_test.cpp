// The questions of rounded.hpp: known answers, and many bodies against the oracle.
#include "ecods/rounded.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "environment/each_environment.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/rounded_bodies.hpp"

namespace ecods {
namespace {

using rounded_bodies::around;
using rounded_bodies::Ball;
using rounded_bodies::expect_right;

struct Case {
    Vec3 between;
    double distance;
};

// Differences of lattice points whose length is an integer.
const std::vector<Case> pythagorean{
    {{2, 3, 6}, 7}, {{1, 2, 2}, 3}, {{4, -4, 7}, 9}, {{0, 0, 5}, 5}, {{-12, 16, 21}, 29}};

TEST(Rounded, LatticeBallsThatTouch) {
    for (const Case& each : pythagorean) {
        for (const double r : {0.0, 0.25, 1.0, 2.5}) {
            const Ball a = sphere(r), b = sphere(each.distance - r);
            const Posed<Rounded> first(a, Pose()), second(b, at(each.between));
            EXPECT_TRUE(intersects(first, second));
            EXPECT_EQ(relation(first, second), Relation::touching);
            EXPECT_EQ(distance(first, second), 0);
            const ClosestPoints points = closest(first, second);
            EXPECT_EQ(points.kind, ClosestKind::vertex_vertex);
            EXPECT_EQ(points.point_a, points.point_b);
            const Ball less = sphere(std::nextafter(each.distance - r, 0));
            EXPECT_FALSE(intersects(first, {less, second.pose}));
            EXPECT_EQ(relation({less, second.pose}, first), Relation::apart);
            expect_right(first, second);
            expect_right(first, {less, second.pose});
        }
    }
}

TEST(Rounded, BallsWhoseRadiiHaveNoSumAmongDoubles) {
    const Ball one = sphere(1), tiny = sphere(0x1p-60);
    EXPECT_EQ(relation({one, Pose()}, {tiny, at(1)}), Relation::overlapping);
    EXPECT_EQ(relation({tiny, at(-1)}, {one, Pose()}), Relation::overlapping);
    const Ball large = sphere(1e300), small = sphere(1e-300);
    EXPECT_EQ(relation({large, Pose()}, {small, at(1e300)}), Relation::overlapping);
    EXPECT_EQ(relation({large, Pose()}, {small, at(0, std::nextafter(1e300, 2e300))}), Relation::apart);
    EXPECT_EQ(distance({large, Pose()}, {small, at(0, std::nextafter(1e300, 2e300))}),
              std::nextafter(1e300, 2e300) - 1e300);
    // The sum of three numbers counts, too.
    EXPECT_TRUE(within(Posed<Rounded>(one, Pose()), {tiny, at(3)}, 2));
    EXPECT_FALSE(within(Posed<Rounded>(one, Pose()), {sphere(0), at(std::nextafter(3.0, 4))}, 2));
    EXPECT_TRUE(within(Posed<Rounded>(one, Pose()), {sphere(0x1p-52), at(std::nextafter(3.0, 4))}, 2 + 0x1p-51));
    const auto cube = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    const Posed<Rounded> padded(rounded(cube, 1), Pose()), other(rounded(cube, 0x1p-60), at(std::nextafter(2.0, 3)));
    EXPECT_EQ(relation(padded, other), Relation::apart);
    EXPECT_EQ(relation(padded, {other.kept, at(2)}), Relation::overlapping);
    expect_right({one, Pose()}, {tiny, at(1)});
    expect_right({large, Pose()}, {small, at(1e300)});
}

TEST(Rounded, DistancesBelowTheLeastDouble) {
    const Ball ball = sphere(1), point = sphere(0);
    const Pose beside = at(1, 0x1p-1000);
    EXPECT_EQ(distance({ball, Pose()}, {point, beside}), 0x1p-1074);
    EXPECT_FALSE(intersects(Posed<Rounded>(ball, Pose()), {point, beside}));
    EXPECT_TRUE(within(Posed<Rounded>(ball, Pose()), {point, beside}, 0x1p-1074));
    EXPECT_EQ(relation({ball, Pose()}, {sphere(0x1p-1074), beside}), Relation::overlapping);
    expect_right({ball, Pose()}, {point, beside});
}

// Both points round to the same distance from the center. What remains without the radius does not.
TEST(Rounded, TheNearerOfTwoPointsThatRoundAlike) {
    const auto points = [](double x, double y) {
        return Mesh::create({Vec3(1, x, 0), Vec3(-1, y, 0)}, {Triangle{0, 0, 0}, Triangle{1, 1, 1}});
    };
    for (const auto& [x, y] : {std::pair(0x1p-30, 0x1p-31), std::pair(0x1p-31, 0x1p-30), std::pair(0x1p-40, 0x1p-45)}) {
        const Ball ball = sphere(1), pair = around(points(x, y), 0);
        EXPECT_EQ(distance({ball, Pose()}, {pair, Pose()}), std::min(x, y) * std::min(x, y) / 2);
        expect_right({ball, Pose()}, {pair, Pose()});
    }
}

TEST(Rounded, ACapsuleAndABoxWithAMargin) {
    const Ball bone = capsule({0, 0, -2}, {0, 0, 2}, 0.5);
    const auto box = std::make_shared<const ConvexSolid>(scenes::cube(1));
    const Ball padded = rounded(box, 1);
    // Edge of the box at (4, 5), the bone's axis at (1, 1): 3 and 4 apart.
    EXPECT_EQ(distance({padded, at(5, 6, 0)}, {bone, at(1, 1, 0)}), 3.5);
    EXPECT_EQ(distance({box, at(5, 6, 0)}, {bone, at(1, 1, 0)}), 4.5);
    EXPECT_EQ(distance({bone, at(1, 1, 0)}, {box, at(5, 6, 0)}), 4.5);
    const ClosestPoints points = closest(Posed<Rounded>(padded, at(5, 6, 0)), {bone, at(1, 1, 0)});
    EXPECT_EQ(points.point_a.head<2>(), Eigen::Vector2d(3.4, 4.2));
    EXPECT_EQ(points.point_b.head<2>(), Eigen::Vector2d(1.3, 1.4));
    // A rod inside a box: a solid contains it; a surface does not.
    const Ball rod = capsule({0, 0, -0.25}, {0, 0, 0.25}, 0.125);
    EXPECT_EQ(relation({rod, Pose()}, {box, Pose()}), Relation::inside);
    EXPECT_EQ(distance({rod, Pose()}, {box, Pose()}), 0);
    EXPECT_EQ(closest(Posed<Rounded>(rod, Pose()), {box, Pose()}).kind, ClosestKind::contained);
    const auto surface = surface_of(*box);
    EXPECT_EQ(relation({rod, Pose()}, {surface, Pose()}), Relation::apart);
    EXPECT_EQ(distance({rod, Pose()}, {surface, Pose()}), 0.625);
    EXPECT_EQ(relation({rod, at(0.875)}, {surface, Pose()}), Relation::touching);
    EXPECT_EQ(relation({rod, at(1)}, {surface, Pose()}), Relation::crossing);
    EXPECT_EQ(relation({rod, at(0.875)}, {box, Pose()}), Relation::inside) << "touches from inside";
    EXPECT_EQ(relation({rod, at(std::nextafter(0.875, 1))}, {box, Pose()}), Relation::overlapping);
}

TEST(Rounded, WithoutARadiusItIsItsCoreAtEqualCost) {
    const auto mesh = std::make_shared<const MeshShape>(scenes::torus(20, 10, 0.25));
    const auto hull = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    const Ball a = rounded(mesh, 0), b = rounded(hull, -0.0);
    scenes::Random random(3);
    for (int i = 0; i < 40; ++i) {
        Pose pose = random.turned();
        pose.t = random.direction() * random.uniform(0, 3);
        QueryCounts of_cores, of_rounded;
        const Posed<MeshShape> x(mesh, Pose()), y(hull, pose);
        const Posed<Rounded> p(a, Pose()), q(b, pose);
        EXPECT_EQ(intersects(p, q, of_rounded), within(x, y, 0, of_cores));
        EXPECT_EQ(distance(p, q, of_rounded), distance(x, y, of_cores));
        EXPECT_EQ(within(p, q, 0.5, of_rounded), within(x, y, 0.5, of_cores));
        EXPECT_EQ(relation(p, q, of_rounded), relation(x, y, of_cores));
        const ClosestPoints of_p = closest(p, q, of_rounded), of_x = closest(x, y, of_cores);
        EXPECT_EQ(of_p.point_a, of_x.point_a);
        EXPECT_EQ(of_p.b, of_x.b);
        EXPECT_EQ(of_rounded, of_cores);
        EXPECT_EQ(a->box(pose), mesh->box(pose));
    }
}

TEST(Rounded, RandomBodiesAsTheOracle) {
    scenes::Random random(4);
    const auto point = [&] { return Vec3(random.direction() * random.uniform(0, 2)); };
    const auto body = [&]() -> Ball {
        const double radius = random.below(4) == 0 ? 0.25 * random.below(4) : random.uniform(0, 1.5);
        switch (random.below(4)) {
            case 0:
                return sphere(radius, point());
            case 1:
                return capsule(point(), point(), radius);
            case 2:
                return around(scenes::one_triangle({point(), point(), point()}), radius);
            default:
                return around(scenes::sphere(6, 4), radius);
        }
    };
    const auto pose = [&] {
        Pose result = random.turned();
        if (random.below(3) == 0) result.R.col(random.below(3)) *= random.below(3) - 1.0;  // singular, or a mirror
        if (random.below(3) == 0) result.R(0, 1) += random.uniform(-2, 2);
        result.t = random.direction() * random.uniform(0, 5);
        return result;
    };
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const Ball a = body(), b = body();
        expect_right({a, pose()}, {b, pose()});
        if (testing::Test::HasFailure()) return;
    }
}

// Spheres and capsules at poses that round, nearer to contact than doubles can tell.
TEST(Rounded, NearContacts) {
    scenes::Random random(6);
    for (int i = 0; i < 800; ++i) {
        // Two balls, or two rods of which the middles are near each other, far from where their coordinates begin.
        const double size = i % 3 == 0 ? 2 : 2000;
        Pose pose_a = random.turned(), pose_b = random.turned();
        pose_a.t = random.direction() * random.uniform(0, 100);
        const Vec3 u = random.direction() * size, gap = random.direction() * random.uniform(0.5, 1);
        const bool are_balls = random.below(2) == 0;
        pose_b.t = pose_a.t + gap;
        const Vec3 v = are_balls ? Vec3(pose_b.R.transpose() * (pose_a.R * u)) : Vec3(random.direction() * size);
        const Ball a = are_balls ? sphere(0, u) : capsule(-u, u, 0), b = are_balls ? sphere(0, v) : capsule(-v, v, 0);
        const oracle::ExactClosest cores = rounded_bodies::closest_of_cores({a, pose_a}, {b, pose_b});
        const double d = oracle::RoundedDistance(cores, 0, 0).distance();
        if (d < 0x1p-10) continue;
        const double r = d * random.uniform(0, 1);
        double s = d - r;
        for (std::uint32_t k = random.below(4); k > 0; --k) s = std::nextafter(s, i % 2 == 0 ? 0 : 10);
        const oracle::RoundedDistance truth(cores, r, s);
        const Posed<Rounded> x(rounded(a, r), pose_a), y(rounded(b, s), pose_b);
        EXPECT_EQ(intersects(x, y), truth.compare(0) <= 0);
        EXPECT_EQ(within(Posed<Rounded>(a, pose_a), y, r), truth.compare(0) <= 0);
        EXPECT_EQ(relation(x, y) == Relation::apart, truth.compare(0) > 0);
        EXPECT_EQ(distance(x, y), truth.distance());
    }
}

// Coordinates and radii of few digits: ties, touching bodies, half-way cases.
TEST(Rounded, LatticeBodiesAsTheOracle) {
    scenes::Random random(5);
    const auto point = [&] { return Vec3(random.below(5), random.below(5), random.below(5)); };
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const double unit = i % 3 == 0 ? 0x1p-1074 : i % 3 == 1 ? 1 : 0x1p1000;
        const Ball a = capsule(unit * point(), unit * point(), unit * random.below(4));
        const Ball b = random.below(2) == 0
                           ? sphere(unit * random.below(6), unit * point())
                           : around(scenes::one_triangle({unit * point(), unit * point(), unit * point()}),
                                    unit * random.below(3));
        expect_right({a, Pose()}, {b, at(unit * point())});
        if (testing::Test::HasFailure()) return;
    }
}

// Contacts in unit, subnormal and huge coordinates.
TEST(Rounded, TheSameInEveryEnvironment) {
    const Ball bone = capsule({0, 0, -2}, {0, 0, 2}, 0.5), ball = sphere(0.1), tiny = sphere(0x1p-60);
    const Ball padded = rounded(std::make_shared<const ConvexSolid>(scenes::cube(1)), 0.1);
    const Ball soup = around(scenes::torus(9, 5, 0.25), 0.3);
    struct Asked {
        Ball other;
        Pose pose, there;
    };
    std::vector<Asked> asked;  // numbers are made before, as they are rounded, too
    for (const double unit : {1.0, 0x1p-1060, 0x1p1000}) {
        for (const Ball& other : {bone, ball, tiny, padded, soup}) {
            for (const Vec3& t : {Vec3(3, 4, 0), Vec3(0.5, 0, 0), Vec3(0.6 + 0x1p-53, 0, 1), Vec3(1.3, 0.1, 0.7)}) {
                asked.push_back({other, {unit * Mat3::Identity(), Vec3::Zero()}, {unit * Mat3::Identity(), unit * t}});
            }
        }
    }
    const auto ask = [&] {
        std::vector<double> all;
        for (const auto& [other, pose, there] : asked) {
            const Posed<Rounded> a(bone, pose), b(other, there);
            const ClosestPoints points = closest(a, b);
            all.insert(all.end(), {distance(a, b), points.distance, points.point_a[0], points.point_b[1]});
            all.push_back(intersects(a, b));
            all.push_back(within(a, b, 0.1));
            EXPECT_LE(key_of(other->box(there).min[0]), key_of(points.point_b[0]));
        }
        std::vector<std::uint64_t> bits;
        for (const double x : all) bits.push_back(std::bit_cast<std::uint64_t>(x));
        return bits;
    };
    const auto expected = ask();
    environment::in_each_environment(
        ask, [&](const auto& got, const std::string& where) { EXPECT_EQ(got, expected) << where; });
}

TEST(Rounded, BoxesContainThem) {
    const Ball bone = capsule({0, 0, 0}, {0, 3, 0}, 1.5);
    const Aabb box = bone->box(at(1, 2, 3));
    for (int axis = 0; axis < 3; ++axis) {
        const double low = axis + 1 - 1.5, high = axis + 1 + 1.5 + (axis == 1 ? 3 : 0);
        EXPECT_LE(box.min[axis], low);
        EXPECT_GE(box.min[axis], low - 0x1p-40);
        EXPECT_GE(box.max[axis], high);
        EXPECT_LE(box.max[axis], high + 0x1p-40);
    }
    const Aabb stretched = bone->box({10 * Mat3::Identity(), Vec3::Zero()});
    EXPECT_NEAR(stretched.max[1], 31.5, 1e-9) << "a pose does not scale the radius";
    EXPECT_LE(sphere(0x1p-1074)->box(Pose()).min[0], -0x1p-1074);
}

TEST(Rounded, Errors) {
    const auto mesh = std::make_shared<const MeshShape>(scenes::cube(1));
    constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-1.0, -0x1p-1074, infinity, nan}) {
        for (const auto& make :
             std::vector<std::function<void()>>{[&] { (void)sphere(bad); },
                                                [&] {
                                                    (void)capsule({0, 0, 0}, {1, 0, 0}, bad);
                                                },
                                                [&] { (void)rounded(mesh, bad); },
                                                [&] { (void)rounded(sphere(1), bad); }, [&] { Rounded(mesh, bad); }}) {
            try {
                make();
                FAIL() << bad;
            } catch (const InvalidArgument& error) {
                EXPECT_EQ(error.argument, Argument::ball);
                EXPECT_EQ(error.part, "radius");
                EXPECT_TRUE(error.value == bad || std::isnan(bad));
            }
        }
    }
    const auto part_of = [](const std::function<void()>& make) -> std::string {
        try {
            make();
        } catch (const InvalidArgument& error) {
            return error.part;
        }
        return "none";
    };
    EXPECT_EQ(part_of([&] { (void)sphere(1, {0, nan, 0}); }), "center(1)");
    EXPECT_EQ(part_of([&] { (void)capsule({0, 0, 0}, {0, 0, infinity}, 1); }), "b(2)");
    EXPECT_EQ(part_of([&] { (void)rounded(nullptr, 1); }), "shape");
    EXPECT_EQ(part_of([&] { Rounded(nullptr, 1); }), "shape");
    EXPECT_EQ(part_of([&] { (void)within(Posed<Rounded>(sphere(1), Pose()), {mesh, Pose()}, nan); }), "");
    EXPECT_EQ(rounded(sphere(1), 0.5)->radius(), 1.5);
    EXPECT_THROW((void)rounded(sphere(1), 0x1p-60), NotSupported);
    EXPECT_EQ(sphere(-0.0)->digest(), sphere(0)->digest());
    EXPECT_NE(sphere(1)->digest(), sphere(0)->digest());
}

}  // namespace
}  // namespace ecods
