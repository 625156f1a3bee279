// Signed distances and depths of rounded bodies: known answers, and bodies on the lattice against the oracle.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

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

using Convex = std::shared_ptr<const ConvexSolid>;

Convex cube(double half) {
    return std::make_shared<const ConvexSolid>(scenes::cube(half));
}
Convex hull_of_sphere(std::uint32_t around, std::uint32_t along) {
    return std::make_shared<const ConvexSolid>(scenes::sphere(around, along)->vertices());
}
Convex tetrahedron(const std::array<Vec3, 4>& corners) {
    return std::make_shared<const ConvexSolid>(std::span<const Vec3>(corners));
}

// Expects the same number of both orders, with the points and the direction turned around if these are the only ones.
SignedDistance expect_turned(const Posed<Rounded>& a, const Posed<Rounded>& b) {
    const SignedDistance found = signed_distance(a, b), back = signed_distance(b, a);
    EXPECT_EQ(found.distance, back.distance);
    EXPECT_FALSE(found.distance == 0 && std::signbit(found.distance));
    if (found.direction == Vec3(-back.direction) && found.a == back.b && found.b == back.a) {
        EXPECT_EQ(found.point_a, back.point_b);
        EXPECT_EQ(found.point_b, back.point_a);
    }
    const Vec3 between = found.point_b - found.point_a - found.distance * found.direction;
    const double size = 1 + std::abs(found.distance) + found.point_a.cwiseAbs().maxCoeff();
    EXPECT_LE(between.cwiseAbs().maxCoeff(), 0x1p-48 * size);
    EXPECT_EQ(found.distance <= 0, intersects(a, b));
    return found;
}

TEST(RoundedSigned, BallsOnTheLattice) {
    struct Case {
        Vec3 between;
        double length;
    };
    for (const Case& each : {Case{{2, 3, 6}, 7}, {{1, 2, 2}, 3}, {{4, -4, 7}, 9}, {{-12, 16, 21}, 29}}) {
        for (const double r : {0.0, 1.0, 4.0, 40.0}) {
            const Ball a = sphere(r), b = sphere(0.5);
            const SignedDistance found = expect_turned({a, Pose()}, {b, at(each.between)});
            EXPECT_EQ(found.distance, each.length - r - 0.5);
            EXPECT_EQ(found.kind, ClosestKind::vertex_vertex);
            EXPECT_EQ(found.direction, Vec3(each.between / each.length));
            const auto deep = depth({a, Pose()}, {b, at(each.between)});
            ASSERT_EQ(deep.has_value(), found.distance <= 0);
            if (deep) {
                EXPECT_EQ(*deep, (Depth{-found.distance, found.a, found.b, found.direction}));
            }
        }
    }
    // Two balls around one point: the x axis.
    const SignedDistance same = expect_turned({sphere(1), Pose()}, {sphere(0x1p-60), Pose()});
    EXPECT_EQ(same.distance, -1);
    EXPECT_EQ(same.direction, Vec3(1, 0, 0));
    EXPECT_EQ(same.point_a, Vec3(1, 0, 0));
    EXPECT_EQ(same.point_b, Vec3(-0x1p-60, 0, 0));
}

TEST(RoundedSigned, ABallInABox) {
    const Convex box = cube(1);
    const Ball ball = sphere(0.25);
    const SignedDistance found = signed_distance(Posed<Rounded>(ball, at(0.5)), {box, Pose()});
    EXPECT_EQ(found.distance, -0.75);
    EXPECT_EQ(found.direction, Vec3(-1, 0, 0)) << "the box moves away from the ball";
    EXPECT_EQ(found.point_a, Vec3(0.25, 0, 0));
    EXPECT_EQ(found.point_b, Vec3(1, 0, 0));
    EXPECT_EQ(found.a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(found.b.kind, Feature::Kind::face);
    const SignedDistance back = signed_distance(Posed<MeshShape>(box, Pose()), {ball, at(0.5)});
    EXPECT_EQ(back.distance, -0.75);
    EXPECT_EQ(back.direction, Vec3(1, 0, 0));
    EXPECT_EQ(back.point_a, found.point_b);
    // On the border, and where the box has a margin, too.
    EXPECT_EQ(signed_distance(Posed<Rounded>(ball, at(1)), {box, Pose()}).distance, -0.25);
    EXPECT_EQ(signed_distance(Posed<Rounded>(ball, at(1.25)), {box, Pose()}).distance, 0);
    EXPECT_EQ(signed_distance({ball, at(0.5)}, {rounded(box, 2), Pose()}).distance, -2.75);
    // A mirror, and a pose that stretches the box: not the margin.
    Pose mirror;
    mirror.R.diagonal() << -4, 1, 1;
    EXPECT_EQ(signed_distance({ball, at(0, 0.5, 0)}, {rounded(box, 2), mirror}).distance, -2.75);
    EXPECT_EQ(signed_distance({ball, at(3.75)}, {rounded(box, 2), mirror}).distance, -2.5);
}

TEST(RoundedSigned, BoxesWithMargins) {
    const Convex box = cube(1), other = cube(0.5);
    for (const double r : {0.0, 0.25, 0x1p-60}) {
        for (const double s : {0.0, 1.5}) {
            const Posed<Rounded> a(rounded(box, r), Pose()), b(rounded(other, s), at(1.25, 0.125, 0));
            const SignedDistance cores = signed_distance({box, Pose()}, {other, b.pose}), found = expect_turned(a, b);
            EXPECT_EQ(found.distance, cores.distance - (r + s));
            EXPECT_EQ(found.direction, cores.direction);
            EXPECT_EQ(found.kind, cores.kind);
            EXPECT_EQ(found.a, cores.a);
            EXPECT_EQ(found.b, cores.b);
            EXPECT_EQ(found.point_a, Vec3(cores.point_a + r * cores.direction));
            EXPECT_EQ(found.point_b, Vec3(cores.point_b - s * cores.direction));
            // Touching cores have a direction, too.
            const Posed<Rounded> beside(rounded(other, s), at(1.5, 0.125, 0));
            const SignedDistance touching = expect_turned(a, beside);
            EXPECT_EQ(touching.distance, -(r + s));
            EXPECT_EQ(touching.direction, Vec3(1, 0, 0));
            EXPECT_EQ(touching.point_a[0], 1 + r);
            EXPECT_EQ(touching.point_b[0], 1 - s);
        }
    }
}

TEST(RoundedSigned, WithoutARadiusItIsThatOfTheSolids) {
    scenes::Random random(11);
    const Convex a = hull_of_sphere(12, 8), b = cube(0.75);
    for (int i = 0; i < 60; ++i) {
        const Pose pose(random.turned().R, random.direction() * random.uniform(0, 3));
        QueryCounts of_cores, of_rounded;
        const Posed<ConvexSolid> x(a, Pose()), y(b, pose);
        EXPECT_EQ(signed_distance({rounded(a, 0), Pose()}, Posed<MeshShape>(b, pose), of_rounded),
                  signed_distance(x, y, of_cores));
        EXPECT_EQ(of_rounded, of_cores);
        EXPECT_EQ(depth({rounded(a, 0), Pose()}, {rounded(b, 0), pose}), depth(x, y));
    }
}

// Points, segments and triangles in solids and in each other, on the lattice and at random poses.
TEST(RoundedSigned, FlatCoresAsTheOracle) {
    scenes::Random random(12);
    int meeting_count = 0;
    for (int i = 0; i < 500; ++i) {
        SCOPED_TRACE(i);
        const double unit = i % 5 == 0 ? 0x1p-1070 : i % 5 == 1 ? 0x1p1000 : 1;
        const auto point = [&] { return Vec3(unit * Vec3(random.below(5), random.below(5), random.below(5))); };
        const auto flat = [&](double radius) -> Ball {
            if (random.below(3) == 0) return sphere(radius, point());
            if (random.below(2) == 0) return capsule(point(), point(), radius);
            return around(scenes::one_triangle({point(), point(), point()}), radius);
        };
        const auto body = [&](double radius) -> Ball {
            if (random.below(2) == 0) return flat(radius);
            const Vec3 p = unit * Vec3(2, 2, 2);
            const std::array corners{Vec3(p + unit * Vec3(2, 0, -1)), Vec3(p + unit * Vec3(-2, 1, -1)),
                                     Vec3(p + unit * Vec3(0, -3, random.below(3))), Vec3(p + unit * Vec3(0, 0, 3))};
            return rounded(tetrahedron(corners), radius);
        };
        const Ball a = flat(unit * random.below(3)), b = body(unit * random.below(3));
        Pose pose_a, pose_b;
        if (unit == 1 && i % 2 == 0) pose_a = random.turned(), pose_b = random.turned();
        if (i % 7 == 0) pose_b.R.col(0) *= -1;
        const Posed<Rounded> x(a, pose_a), y(b, pose_b);
        const SignedDistance found = signed_distance(x, y), back = signed_distance(y, x);
        EXPECT_EQ(found.distance, back.distance);
        if (distance(Posed<Rounded>(rounded(a->core_ptr(), 0), pose_a), {rounded(b->core_ptr(), 0), pose_b}) > 0) {
            const auto cores = rounded_bodies::closest_of_cores(x, y);
            EXPECT_EQ(found.distance, oracle::RoundedDistance(cores, a->radius(), b->radius()).signed_distance());
            continue;
        }
        ++meeting_count;
        const mpq_class square = oracle::squared_depth(oracle::posed_points(a->core().mesh(), pose_a),
                                                       oracle::posed_points(b->core().mesh(), pose_b));
        EXPECT_EQ(found.distance, oracle::minus_depth(square, a->radius(), b->radius()));
        if (unit == 1) expect_turned(x, y);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(meeting_count, 100);
}

// The depth of a point in a convex solid is its distance from the surface, and the foot is there.
TEST(RoundedSigned, ABallsPointsAsThoseOfTheSurface) {
    scenes::Random random(13);
    const Convex solid = hull_of_sphere(9, 7);
    const auto surface = surface_of(*solid);
    for (int i = 0; i < 60; ++i) {
        const Pose pose = random.turned(), there = at(Vec3(random.direction() * random.uniform(0, 0.8)));
        const double r = random.uniform(0, 2), s = random.uniform(0, 2);
        const oracle::ExactClosest cores =
            rounded_bodies::closest_of_cores({sphere(0), there}, {rounded(surface, 0), pose});
        const SignedDistance found = signed_distance({sphere(r), there}, {rounded(solid, s), pose});
        EXPECT_EQ(found.distance, oracle::RoundedDistance(cores, r, s).signed_distance(true));
        EXPECT_EQ(found.point_b, oracle::RoundedDistance(cores, r, -s).point(1));
        EXPECT_EQ(found.point_a, oracle::RoundedDistance(cores, -r, s).point(0));
    }
}

TEST(RoundedSigned, NumbersThatCancelAndRadiiFarApart) {
    for (const double unit : {1.0, 0x1p-1074, 0x1p1000}) {
        for (const Vec3& t : {Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(2, 2, 0), Vec3(1, 1, 1), Vec3(5, 7, 11)}) {
            for (const double r : {1.0, 2.0, 3.0, std::sqrt(2.0), 0x1p-500, 0x1p500, 14.0}) {
                if (unit != 1 && r * unit == 0) continue;
                if (!(r * unit < 1e308)) continue;
                const Posed<Rounded> a(sphere(r * unit), Pose()), b(sphere(unit), at(Vec3(unit * t)));
                const auto cores = rounded_bodies::closest_of_cores(a, b);
                const oracle::RoundedDistance truth(cores, a.what->radius(), b.what->radius());
                const SignedDistance found = signed_distance(a, b);
                EXPECT_EQ(found.distance, truth.signed_distance());
                EXPECT_EQ(found.distance > 0, truth.compare(0) > 0);
                EXPECT_EQ(found.point_a, truth.point(0));
                EXPECT_EQ(found.point_b, truth.point(1));
            }
        }
    }
}

TEST(RoundedSigned, BodiesThatAreNotConvex) {
    const auto mesh = std::make_shared<const MeshShape>(scenes::torus(12, 8, 0.25));
    const Ball ring = rounded(mesh, 0.5), ball = sphere(0.25);
    const Posed<Rounded> in_the_hole(ball, Pose()), touching(ball, at(mesh->mesh().vertices()[0]));
    const double gap =
        distance(Posed<MeshShape>(mesh, Pose()),
                 {std::make_shared<const MeshShape>(Mesh::create({Vec3(0, 0, 0)}, {Triangle{0, 0, 0}})), Pose()});
    ASSERT_GT(gap, 0.25);
    EXPECT_EQ(signed_distance({ring, Pose()}, in_the_hole).distance,
              oracle::RoundedDistance(rounded_bodies::closest_of_cores({ring, Pose()}, in_the_hole), 0.5, 0.25)
                  .signed_distance());
    EXPECT_THROW((void)signed_distance({ring, Pose()}, touching), NotSupported);
    EXPECT_THROW((void)depth({ring, Pose()}, in_the_hole), NotSupported);
    EXPECT_THROW((void)depth(in_the_hole, Posed<MeshShape>(mesh, Pose())), NotSupported);
    Pose flat;
    flat.R(0, 0) = 0;
    const Convex box = cube(1);
    EXPECT_EQ(signed_distance(Posed<MeshShape>(box, flat), {ball, at(2)}).distance, 1.75);
    try {
        (void)signed_distance({ball, Pose()}, Posed<MeshShape>(box, flat));
        FAIL();
    } catch (const SingularPose& error) {
        EXPECT_EQ(error.argument, 1);
    }
}

TEST(RoundedSigned, TheSameInEveryEnvironment) {
    const Ball bone = capsule({0, 0, -2}, {0, 0, 2}, 0.1), padded = rounded(cube(1), 0x1p-60);
    const Ball ball = sphere(0.3), plate = around(scenes::one_triangle({Vec3(-1, -1, 0), {2, 0, 0.5}, {0, 2, 0}}), 0.2);
    struct Asked {
        Posed<Rounded> a, b;
    };
    std::vector<Asked> asked;  // numbers are made before, as they are rounded, too
    for (const double unit : {1.0, 0x1p-1060, 0x1p1000}) {
        const Pose pose(unit * Mat3::Identity(), Vec3::Zero());
        const Pose there(unit * Mat3::Identity(), unit * Vec3(0.625, 0.25, 0));
        for (const Ball& a : {bone, padded, ball, plate}) {
            for (const Ball& b : {bone, padded, ball, plate}) asked.push_back({{a, pose}, {b, there}});
        }
    }
    const auto ask = [&] {
        std::vector<std::uint64_t> all;
        for (const auto& [a, b] : asked) {
            const SignedDistance found = signed_distance(a, b);
            for (const double x : {found.distance, found.direction[0], found.point_a[1], found.point_b[2]}) {
                all.push_back(std::bit_cast<std::uint64_t>(x));
            }
        }
        return all;
    };
    const auto expected = ask();
    environment::in_each_environment(
        ask, [&](const auto& got, const std::string& where) { EXPECT_TRUE(got == expected) << where; });
}

}  // namespace
}  // namespace ecods
