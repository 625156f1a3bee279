// Casts of rounded bodies: known answers, and random bodies against the oracle.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "environment/each_environment.hpp"
#include "geometry/feature_key.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/near_times.hpp"
#include "unit/query/rounded_bodies.hpp"

namespace ecods {
namespace {

using rounded_bodies::around;
using rounded_bodies::Ball;

// The first time up to 1, by all pairs of triangles.
std::optional<double> true_time(const Posed<Rounded>& a, const Vec3& motion, const Posed<Rounded>& b) {
    if (intersects(a, b)) return 0;
    return near_times::first_within({a.what->core(), a.pose}, motion, {b.what->core(), b.pose},
                                    oracle::exactly(a.what->radius()) + oracle::exactly(b.what->radius()));
}

// Expects the contact, and the same one if the other body moves the other way.
std::optional<FirstContact> cast_both(const Posed<Rounded>& a, const Vec3& motion, const Posed<Rounded>& b) {
    const auto found = cast(a, motion, b), back = cast(b, Vec3(-motion), a);
    EXPECT_EQ(found.has_value(), back.has_value());
    if (!found || !back) return std::nullopt;
    EXPECT_EQ(found->time, back->time);
    EXPECT_EQ(found->kind, back->kind);
    for (const double before : {found->time, std::nextafter(found->time, 2)}) {
        const auto by = cast(a, motion, b, before);
        EXPECT_TRUE(!by || *by == *found);
        EXPECT_TRUE(by.has_value() || before <= found->time);
    }
    EXPECT_TRUE(found->time <= 0 || !cast(a, motion, b, std::nextafter(found->time, 0)));
    return found;
}

TEST(RoundedCast, BallsOnTheLattice) {
    const Ball five = sphere(3), two = sphere(2);
    const Posed<Rounded> a(five, Pose());
    const auto time = [&](const Vec3& motion, const Vec3& there) -> std::optional<double> {
        const auto found = cast_both(a, motion, {two, at(there)});
        if (!found) return std::nullopt;
        return found->time;
    };
    EXPECT_EQ(time({10, 0, 0}, {8, 3, 0}), 0.4) << "at (4, 0, 0), (4, 3) from it";
    EXPECT_EQ(time({0, 16, 0}, {4, 11, 0}), 0.5);
    EXPECT_EQ(time({10, 0, 0}, {5, 5, 0}), 0.5) << "it grazes";
    EXPECT_EQ(time({10, 0, 0}, {5, std::nextafter(5.0, 6), 0}), std::nullopt);
    EXPECT_EQ(time({10, 0, 0}, {15, 0, 0}), 1);
    EXPECT_EQ(time({10, 0, 0}, {std::nextafter(15.0, 16), 0, 0}), std::nullopt);
    EXPECT_EQ(time({10, 0, 0}, {5, 0, 0}), 0);
    EXPECT_EQ(time({-10, 0, 0}, {std::nextafter(5.0, 6), 0, 0}), std::nullopt);
    EXPECT_EQ(time({0, 0, 0}, {6, 0, 0}), std::nullopt);
    EXPECT_EQ(time({0, 0, 0}, {5, 0, 0}), 0);
    // An irrational time: the gap of (4, 2) in a ball of 3 is sqrt(5).
    EXPECT_EQ(time({8, 0, 0}, {8, 4, 0}), 0.625);
    const auto grazing = cast(a, {8, 0, 0}, Posed<Rounded>(sphere(0), at(4, 2, 0)));
    EXPECT_EQ(grazing->time, (4 - std::sqrt(5.0)) / 8);
    EXPECT_EQ(grazing->kind, ClosestKind::vertex_vertex);
}

// Unit cubes, four apart, until they are half a unit apart.
TEST(RoundedCast, CubesThatStopBefore) {
    const auto cube = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    const auto mesh = std::make_shared<const MeshShape>(scenes::cube(0.5));
    for (const double r : {0.0, 0.25, 0.5}) {
        const auto found = cast_both({rounded(cube, r), Pose()}, {4, 0, 0}, {rounded(cube, 0.5 - r), at(5)});
        EXPECT_EQ(found->time, 0.875);
        EXPECT_EQ(found->kind, ClosestKind::vertex_vertex);
        EXPECT_EQ(cast(Posed<Rounded>(rounded(mesh, r), Pose()), {4, 0, 0}, {rounded(mesh, 0.5 - r), at(5)}), found);
    }
    // Of the pairs of features at the distance, those of faces that cross have edges, not vertices.
    const auto crossed =
        cast_both({rounded(cube, 0.5), Pose()}, {4, 0, 0},
                  {around(scenes::one_triangle({Vec3(5, -9, 0), {5, 9, 0.25}, {9, 0, 0}}), 0), Pose()});
    EXPECT_EQ(crossed->time, 1);
    EXPECT_EQ(crossed->kind, ClosestKind::edge_edge);
    // A part inside at the start.
    const auto contained = cast(Posed<Rounded>(sphere(0.125), Pose()), {4, 0, 0}, Posed<MeshShape>(cube, Pose()));
    EXPECT_EQ(contained->time, 0);
    EXPECT_EQ(contained->kind, ClosestKind::contained);
    EXPECT_FALSE(cast(Posed<Rounded>(sphere(0.125), Pose()), {0.375, 0, 0}, Posed<MeshShape>(mesh, Pose()), 0.5));
    EXPECT_EQ(cast(Posed<Rounded>(sphere(0.125), Pose()), {0.375, 0, 0}, Posed<MeshShape>(mesh, Pose()))->time, 1);
}

TEST(RoundedCast, WithoutRadiiItIsThatOfTheCores) {
    const auto ring = std::make_shared<const MeshShape>(scenes::torus(20, 10, 0.25));
    const auto cube = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    scenes::Random random(31);
    for (int i = 0; i < 60; ++i) {
        Pose pose = random.turned();
        pose.t = random.direction() * random.uniform(0, 4);
        const Vec3 motion = -pose.t + random.direction();
        QueryCounts of_cores, of_rounded;
        EXPECT_EQ(cast({rounded(cube, 0), pose}, motion, Posed<MeshShape>(ring, Pose()), 1, of_rounded),
                  cast(Posed<MeshShape>(cube, pose), motion, {ring, Pose()}, 1, of_cores));
        EXPECT_EQ(of_rounded, of_cores);
    }
}

TEST(RoundedCast, RandomTrianglesAsTheOracle) {
    scenes::Random random(32);
    int contact_count = 0;
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(i);
        const bool on_lattice = i % 3 == 0;
        const auto point = [&] {
            if (on_lattice) return Vec3(random.below(4), random.below(4), random.below(4));
            return Vec3(random.direction() * random.uniform(0, 2));
        };
        const auto body = [&] {
            const double radius = on_lattice ? 0.5 * random.below(4) : random.uniform(0, 1);
            if (random.below(4) == 0) return sphere(radius, point());
            if (random.below(3) == 0) return capsule(point(), point(), radius);
            return around(scenes::one_triangle({point(), point(), point()}), radius);
        };
        const Ball a = body(), b = body();
        if (a->radius() == 0 && b->radius() == 0) continue;
        Pose pose = on_lattice ? Pose() : random.turned();
        if (i % 5 == 0) pose.R(0, 1) += 0.5;
        pose.t = on_lattice ? Vec3(8, random.below(4), 0) : Vec3(random.direction() * random.uniform(3, 8));
        const Vec3 motion = on_lattice ? Vec3(-16, 0, 0) : Vec3(-1.5 * pose.t + random.direction());
        const Posed<Rounded> x(a, pose), y(b, Pose());
        const auto found = cast_both(x, motion, y);
        const auto expected = true_time(x, motion, y);
        ASSERT_EQ(found.has_value(), expected.has_value());
        contact_count += found.has_value();
        EXPECT_TRUE(!found || found->time == *expected);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(contact_count, 60);
}

// The walk and its parts find what each pair of triangles has.
TEST(RoundedCast, MeshesAsTheirTriangles) {
    const auto ring = scenes::torus(9, 5, 0.25), ball = scenes::sphere(3, 2);
    scenes::Random random(33);
    const auto part = [](const std::shared_ptr<const Mesh>& mesh, std::uint32_t triangle) {
        return Mesh::create({mesh->vertices().begin(), mesh->vertices().end()}, {mesh->triangles()[triangle]});
    };
    int contact_count = 0;
    for (int i = 0; i < 9; ++i) {
        const double r = i % 4 == 0 ? 0.25 : random.uniform(0, 0.5);
        Pose pose = i % 3 == 0 ? Pose() : random.turned();
        pose.t = i % 3 == 0 ? Vec3(4, 0, 0) : Vec3(random.direction() * 4);
        const Vec3 motion = i % 3 == 0 ? Vec3(-4, 0, 0) : Vec3(-pose.t + random.direction());
        const auto found = cast({around(ball, r), pose}, motion, Posed<Rounded>(around(ring, 0.125), Pose()));
        std::optional<FirstContact> least;
        for (std::uint32_t k = 0; k < ball->triangles().size(); ++k) {
            for (std::uint32_t j = 0; j < ring->triangles().size(); ++j) {
                auto of_pair = cast({around(part(ball, k), r), pose}, motion,
                                    Posed<Rounded>(around(part(ring, j), 0.125), Pose()));
                if (!of_pair) continue;
                of_pair->a.triangle = k;
                of_pair->b.triangle = j;
                if (!least || std::pair(of_pair->time, rank(*of_pair)) < std::pair(least->time, rank(*least))) {
                    least = of_pair;
                }
            }
        }
        EXPECT_EQ(found, least) << i;
        contact_count += found.has_value();
    }
    EXPECT_GT(contact_count, 3);
}

// Times have no unit: all lengths times a power of two leave them as they are.
TEST(RoundedCast, SmallAndLargeUnits) {
    scenes::Random random(34);
    for (int i = 0; i < 40; ++i) {
        const auto point = [&] { return Vec3(random.below(9), random.below(9), random.below(9)); };
        const std::array<Vec3, 3> corners{point(), point(), point()};
        const Vec3 center = point(), motion(random.below(9) - 20.0, random.below(5), 1);
        const double r = random.below(5), s = 1;
        std::optional<FirstContact> expected;
        for (const double unit : {1.0, 0x1p-1070, 0x1p1015, 0x1p-200}) {
            const Ball a = sphere(unit * r, unit * center);
            const Ball b =
                around(scenes::one_triangle({unit * corners[0], unit * corners[1], unit * corners[2]}), unit * s);
            const auto found = cast({a, at(Vec3(unit * Vec3(16, 0, 0)))}, unit * motion, Posed<Rounded>(b, Pose()));
            if (unit == 1) expected = found;
            EXPECT_EQ(found, expected) << unit;
        }
    }
    // Radii far apart, and a time below the least double.
    const auto far = cast({sphere(0x1p500), Pose()}, {0x1p501, 0, 0},
                          Posed<Rounded>(sphere(0x1p-500), at(std::nextafter(0x1p500, 0x1p501))));
    EXPECT_EQ(far->time, 0x1p-53);
    const auto least = cast({sphere(0x1p-1074), Pose()}, {0x1p1000, 0, 0}, Posed<Rounded>(sphere(0), at(0x1p-1073)));
    EXPECT_EQ(least->time, 0x1p-1074);
    EXPECT_FALSE(cast({sphere(0x1p-1074), Pose()}, {0x1p1000, 0, 0}, Posed<Rounded>(sphere(0), at(0x1p-1073)), 0));
}

TEST(RoundedCast, AgainstAHalfSpace) {
    const HalfSpace ground(Vec3(0, 3, 4), 0);  // the normal has length 5
    const auto contact = cast(Posed<Rounded>(sphere(1), at(0, 0, 5)), Vec3(0, 0, -10), {ground, Pose()});
    EXPECT_EQ(contact, (FirstContact{0.375, ClosestKind::vertex_face, {}, {Feature::Kind::face, 0, 0}}));
    const auto of_core = cast(Posed<MeshShape>(sphere(1)->core_ptr(), at(0, 0, 5)), Vec3(0, 0, -10), {ground, Pose()});
    EXPECT_EQ(of_core->time, 0.5);
    EXPECT_EQ(cast(Posed<Rounded>(sphere(0), at(0, 0, 5)), Vec3(0, 0, -10), {ground, Pose()}), of_core);
    EXPECT_EQ(cast(Posed<Rounded>(sphere(4), at(0, 0, 5)), Vec3(0, 1, 0), {ground, Pose()})->time, 0) << "it touches";
    EXPECT_FALSE(cast(Posed<Rounded>(sphere(3), at(0, 0, 5)), Vec3(0, 1, 0), {ground, Pose()}));
    EXPECT_FALSE(cast(Posed<Rounded>(sphere(1), at(0, 0, 5)), Vec3(0, 0, -10), {ground, Pose()}, 0.25));
    const HalfSpace floor(Vec3(1, 1, 1), 0);
    EXPECT_EQ(cast(Posed<Rounded>(sphere(1), at(3, 3, 3)), Vec3(-3, -3, -3), {floor, Pose()})->time,
              oracle::nearest({1, -1, mpq_class(1, 27)}));
}

TEST(RoundedCast, Errors) {
    const Posed<Rounded> a(sphere(1), Pose()), b(sphere(1), at(5));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)cast(a, {nan, 0, 0}, b), InvalidArgument);
    EXPECT_THROW((void)cast(a, {1, 0, 0}, b, nan), InvalidArgument);
    EXPECT_THROW((void)cast(a, {1, 0, 0}, b, -1), InvalidArgument);
    EXPECT_EQ(cast(a, {3, 0, 0}, b, 7)->time, 1);
}

TEST(RoundedCast, TheSameInEveryEnvironment) {
    struct Asked {
        Posed<Rounded> a, b;
        Vec3 motion;
    };
    std::vector<Asked> asked;
    const Ball bone = capsule({0, 0, -2}, {0, 0, 2}, 0.1),
               padded = rounded(std::make_shared<const ConvexSolid>(scenes::cube(1)), 0.3);
    const Ball soup = around(scenes::torus(9, 5, 0.25), 0.2);
    for (const double unit : {1.0, 0x1p-1060, 0x1p1000}) {
        for (const Ball& body : {bone, padded, soup}) {
            const Pose pose(unit * Mat3::Identity(), Vec3::Zero());
            const Pose there(unit * Mat3::Identity(), unit * Vec3(5, 0.5, 0.25));
            asked.push_back({{body, there}, {soup, pose}, unit * Vec3(-6, 0.1, -0.3)});
        }
    }
    const auto ask = [&] {
        std::vector<std::optional<FirstContact>> all;
        for (const auto& [a, b, motion] : asked) all.push_back(cast(a, motion, b));
        return all;
    };
    const auto expected = ask();
    EXPECT_TRUE(expected[0] && expected[0]->time > 0);
    environment::in_each_environment(
        ask, [&](const auto& got, const std::string& where) { EXPECT_TRUE(got == expected) << where; });
}

}  // namespace
}  // namespace ecods
