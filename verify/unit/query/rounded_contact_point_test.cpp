// Points and normals of first contacts of rounded bodies: known answers, and random triangles against the oracle.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "environment/each_environment.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/near_times.hpp"
#include "unit/query/rounded_bodies.hpp"

namespace ecods {
namespace {

using rounded_bodies::around;
using rounded_bodies::Ball;

// Returns the point and the normal of the first contact. Expects the opposite normal if the other body moves against
// it, and the same point there, which moves along.
template <class A, class B>
ContactPoint point_of(const Posed<A>& a, const Vec3& motion, const Posed<B>& b, std::optional<ClosestKind> kind = {}) {
    const auto contact = cast(a, motion, b);
    EXPECT_TRUE(contact);
    if (!contact) return {};
    EXPECT_EQ(contact->kind, kind.value_or(contact->kind));
    const ContactPoint found = contact_point(a, motion, b, *contact);
    const auto turned = cast(b, Vec3(-motion), a);
    EXPECT_TRUE(turned && turned->time == contact->time);
    if (!turned || turned->a != contact->b || turned->b != contact->a) return found;
    const ContactPoint back = contact_point(b, Vec3(-motion), a, *turned);
    EXPECT_EQ(back.normal.has_value(), found.normal.has_value());
    if (found.normal) {
        EXPECT_EQ(*back.normal, Vec3(-*found.normal));
    }
    return found;
}

// Times and directions of the triangles (3, 4, 5) and (5, 12, 13).
TEST(RoundedContactPoint, BallsOnTheLattice) {
    const ContactPoint balls = point_of(Posed<Rounded>(sphere(3), Pose()), {10, 0, 0},
                                        Posed<Rounded>(sphere(2), at(8, 3, 0)), ClosestKind::vertex_vertex);
    EXPECT_EQ(balls.point, Vec3(6.4, 1.8, 0));
    EXPECT_EQ(balls.normal, Vec3(0.8, 0.6, 0));
    const ContactPoint long_ones = point_of(Posed<Rounded>(sphere(1), Pose()), {0, 0, 16},
                                            Posed<Rounded>(sphere(12), at(0, 5, 20)), ClosestKind::vertex_vertex);
    EXPECT_EQ(long_ones.point, Vec3(0, 5.0 / 13, 8 + 12.0 / 13));
    EXPECT_EQ(long_ones.normal, Vec3(0, 5.0 / 13, 12.0 / 13));
    const ContactPoint bone =
        point_of(Posed<Rounded>(sphere(2), at(-10, 3, 0.5)), {20, 0, 0},
                 Posed<Rounded>(capsule({0, 0, -2}, {0, 0, 2}, 3), Pose()), ClosestKind::vertex_edge);
    EXPECT_EQ(bone.point, Vec3(-2.4, 1.8, 0.5));
    EXPECT_EQ(bone.normal, Vec3(0.8, -0.6, 0));
    const ContactPoint at_its_end = point_of(Posed<Rounded>(capsule({0, 0, -2}, {0, 0, 2}, 3), Pose()), {10, 0, 0},
                                             Posed<Rounded>(sphere(2), at(8, 3, 2)), ClosestKind::vertex_vertex);
    EXPECT_EQ(at_its_end.point, Vec3(6.4, 1.8, 2));
    // A ball without a radius is a point, and it is the point of contact.
    const ContactPoint point = point_of(Posed<Rounded>(sphere(5), Pose()), {10, 0, 0},
                                        Posed<Rounded>(sphere(0), at(8, 3, 0)), ClosestKind::vertex_vertex);
    EXPECT_EQ(point.point, Vec3(8, 3, 0));
    EXPECT_EQ(point.normal, Vec3(0.8, 0.6, 0));
}

TEST(RoundedContactPoint, OfFacesAndEdges) {
    const auto floor = std::make_shared<const ConvexSolid>(scenes::cube(4));
    for (const double r : {0.0, 0.25, 0.5}) {
        const ContactPoint lands =
            point_of(Posed<Rounded>(sphere(0.5), at(0.25, 0.5, 8)), {2, 0, -8},
                     Posed<Rounded>(rounded(floor, r), at(0, 0, r == 0.5 ? -1 : 0)), ClosestKind::vertex_face);
        const double height = r == 0.5 ? 3.5 : 4 + r, time = (8 - 0.5 - height) / 8;
        EXPECT_EQ(lands.point, Vec3(0.25 + 2 * time, 0.5, height));
        EXPECT_EQ(lands.normal, Vec3(0, 0, -1));
    }
    const ContactPoint on_mesh = point_of(Posed<Rounded>(sphere(0.5), at(0.25, 0.5, 8)), {0, 0, -8},
                                          Posed<MeshShape>(*floor, Pose()), ClosestKind::vertex_face);
    EXPECT_EQ(on_mesh.point, Vec3(0.25, 0.5, 4));
    const ContactPoint of_mesh = point_of(Posed<MeshShape>(*floor, at(0, 0, 8)), {0, 0, -8},
                                          Posed<Rounded>(sphere(0.5), at(0.25, 0.5, 0)), ClosestKind::vertex_face);
    EXPECT_EQ(of_mesh.point, Vec3(0.25, 0.5, 0.5));
    EXPECT_EQ(of_mesh.normal, Vec3(0, 0, -1));
    const ContactPoint crossed =
        point_of(Posed<Rounded>(capsule({-2, 0, 0}, {2, 0, 0}, 1), at(0.25, 0, 8)), {0, 0, -8},
                 Posed<Rounded>(capsule({0, -2, 0}, {0, 2, 0}, 3), at(0, 0.5, 0)), ClosestKind::edge_edge);
    EXPECT_EQ(crossed.point, Vec3(0, 0, 3));
    EXPECT_EQ(crossed.normal, Vec3(0, 0, -1));
    // Obliquely: at time 1/2 the first one is at (0, 0, 4), whatever it does along both.
    const ContactPoint oblique =
        point_of(Posed<Rounded>(capsule({-9, 0, 0}, {9, 0, 0}, 1), at(-3, 1, 8)), {6, -2, -8},
                 Posed<Rounded>(capsule({0, -9, 0}, {0, 9, 0}, 3), Pose()), ClosestKind::edge_edge);
    EXPECT_EQ(oblique.point, Vec3(0, 0, 3));
}

// At time 0 the point is one that both bodies have, and there is no normal.
TEST(RoundedContactPoint, AtTheStart) {
    const auto cube = std::make_shared<const ConvexSolid>(scenes::cube(1));
    const ContactPoint overlap =
        point_of(Posed<Rounded>(sphere(3), Pose()), {1, 0, 0}, Posed<Rounded>(sphere(2), at(4, 0, 0)));
    EXPECT_EQ(overlap.point, Vec3(2.4, 0, 0));
    EXPECT_FALSE(overlap.normal);
    const ContactPoint small =
        point_of(Posed<Rounded>(sphere(0.25), at(1, 0, 0)), {1, 0, 0}, Posed<Rounded>(sphere(7.75), Pose()));
    EXPECT_EQ(small.point, Vec3(1 - 0.25 / 8, 0, 0));
    const ContactPoint above = point_of(Posed<Rounded>(sphere(0.5), at(0.25, 0.125, 1.25)), {0, 0, -1},
                                        Posed<Rounded>(rounded(cube, 0.5), Pose()), ClosestKind::vertex_face);
    EXPECT_EQ(above.point, Vec3(0.25, 0.125, 1.125));
    const Posed<Rounded> inside(sphere(0.125), at(0.25, 0, 0));
    EXPECT_EQ(point_of(inside, {4, 0, 0}, Posed<MeshShape>(*cube, Pose()), ClosestKind::contained).point,
              Vec3(0.25, 0, 0));
    const auto at_rest = cast(Posed<Rounded>(sphere(3), Pose()), {0, 0, 0}, Posed<Rounded>(sphere(2), at(4, 0, 0)));
    EXPECT_EQ(
        contact_point(Posed<Rounded>(sphere(3), Pose()), {0, 0, 0}, Posed<Rounded>(sphere(2), at(4, 0, 0)), *at_rest)
            .point,
        Vec3(2.4, 0, 0));
}

TEST(RoundedContactPoint, WithoutRadiiItIsThatOfTheCores) {
    const auto cube = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    for (const Vec3& from : {Vec3(0.25, 0.5, 4), Vec3(1, 0.25, 4), Vec3(1, 1, 4)}) {
        const Vec3 motion(0, 0, -8);
        const Posed<Rounded> a(rounded(cube, 0), {.t = from}), b(rounded(cube, 0), Pose());
        const Posed<MeshShape> core_a(*cube, a.pose), core_b(*cube, Pose());
        const auto contact = cast(a, motion, b);
        ASSERT_TRUE(contact);
        EXPECT_EQ(contact_point(a, motion, b, *contact), contact_point(core_a, motion, core_b, *contact));
    }
}

// The middle of two doubles is rounded to the even one, although the time is irrational.
TEST(RoundedContactPoint, Ties) {
    const double one = 1, next = std::nextafter(one, 2), after = std::nextafter(next, 2);
    const Ball ball = sphere(1);
    const auto height = [&](double low, double high) {
        const Posed<Rounded> a(ball, {.t = {0, low, 0}}), b(ball, {.t = {4, high, 0.75}});
        return contact_point(a, {8, 0, 0}, b, *cast(a, {8, 0, 0}, b)).point[1];
    };
    environment::in_each_environment(
        [&] {
            return std::array{height(one, next), height(next, after), height(next, one)};
        },
        [&](const std::array<double, 3>& got, const std::string& where) {
            EXPECT_EQ(got, (std::array{one, after, one})) << where;
        });
}

TEST(RoundedContactPoint, WhatIsNoContactIsRefused) {
    const Posed<Rounded> a(sphere(3), Pose()), b(sphere(2), at(8, 3, 0));
    const Vec3 motion(10, 0, 0);
    const FirstContact contact = *cast(a, motion, b);
    const auto refused = [&](const FirstContact& other, const Vec3& way) {
        EXPECT_THROW(std::ignore = contact_point(a, way, b, other), NotSupported);
    };
    refused(contact, {10, 0.25, 0});
    refused(contact, {0, 0, 0});
    refused(contact, {-10, 0, 0});
    FirstContact other = contact;
    other.time = std::nextafter(other.time, 1);
    refused(other, motion);
    other = contact;
    other.time = std::nan("");
    refused(other, motion);
    other.time = 0;
    refused(other, motion);
    other = contact;
    other.a.triangle = 4000;
    refused(other, motion);
    other = contact;
    other.b.corner = 3;
    refused(other, motion);
    other = contact;
    other.b = no_feature;
    refused(other, motion);
    other = contact;
    other.kind = ClosestKind::contained;
    refused(other, motion);
    other.kind = ClosestKind::vertex_edge;
    refused(other, motion);
    EXPECT_INVALID(contact_point(a, {NAN, 0, 0}, b, contact), Argument::motion);
}

// What the oracle says of the contact of two triangles: at two times between which the exact one is, and that are next
// to nothing apart.
struct Expected {
    oracle::Vector<mpq_class> point[2], normal[2];
};

std::optional<Expected> expected_of(const Posed<MeshShape>& a, double r, const Vec3& motion, const Posed<MeshShape>& b,
                                    double s, const FirstContact& contact) {
    const oracle::Vector<mpq_class> way{oracle::exactly(motion[0]), oracle::exactly(motion[1]),
                                        oracle::exactly(motion[2])};
    const mpq_class p = oracle::exactly(r) + oracle::exactly(s);
    const oracle::RoundedMotion pair(near_times::corners_of(a, contact.a.triangle),
                                     near_times::corners_of(b, contact.b.triangle), way, p);
    const auto bits = std::bit_cast<std::uint64_t>(contact.time);
    mpq_class low = oracle::middle_above(bits - 1), high = oracle::middle_above(bits);
    if (pair.is_near(low) || !pair.is_near(high)) return std::nullopt;
    for (int i = 0; i < 250; ++i) {
        const mpq_class middle = (low + high) / 2;
        (pair.is_near(middle) ? high : low) = middle;
    }
    Expected expected;
    for (std::size_t end = 0; end < 2; ++end) {
        const auto [x, y] = pair.closest(end == 0 ? low : high);
        for (std::size_t k = 0; k < 3; ++k) {
            expected.normal[end][k] = (y[k] - x[k]) / p;
            expected.point[end][k] = x[k] + oracle::exactly(r) * (y[k] - x[k]) / p;
        }
    }
    return expected;
}

// Compares numbers that are the same at both times. Returns how many.
int compare_with(const Expected& expected, const ContactPoint& found) {
    int count = 0;
    const auto compare = [&](const oracle::Vector<mpq_class>* ends, const Vec3& got) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double low = oracle::nearest({ends[0][k], 0, 0}), high = oracle::nearest({ends[1][k], 0, 0});
            if (low != high) continue;
            EXPECT_EQ(got[static_cast<int>(k)], low);
            ++count;
        }
    };
    compare(expected.point, found.point);
    compare(expected.normal, *found.normal);
    return count;
}

TEST(RoundedContactPoint, RandomTrianglesAsTheOracle) {
    scenes::Random random(41);
    int kinds[4] = {}, number_count = 0;
    for (int i = 0; i < 300; ++i) {
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
        Pose pose = on_lattice ? Pose() : random.turned();
        if (i % 5 == 0) pose.R(0, 1) += 0.5;
        pose.t = on_lattice ? Vec3(8, random.below(4), 0) : Vec3(random.direction() * random.uniform(3, 8));
        const Vec3 motion = on_lattice ? Vec3(-16, 0, 0) : Vec3(-1.5 * pose.t + random.direction());
        const Posed<Rounded> x(a, pose), y(b, Pose());
        const auto contact = cast(x, motion, y);
        if (!contact || contact->time <= 0 || a->radius() + b->radius() <= 0) continue;
        const ContactPoint found = point_of(x, motion, y);
        ASSERT_TRUE(found.normal);
        const auto expected =
            expected_of({a->core(), pose}, a->radius(), motion, {b->core(), Pose()}, b->radius(), *contact);
        if (!expected) continue;
        ++kinds[static_cast<int>(contact->kind)];
        number_count += compare_with(*expected, found);
        if (testing::Test::HasFailure()) return;
    }
    for (const int count : kinds) EXPECT_GT(count, 5);
    EXPECT_GT(number_count, 600);
}

// Of meshes the contact names two of many triangles.
TEST(RoundedContactPoint, MeshesAsTheirTriangles) {
    scenes::Random random(42);
    const auto ring = std::make_shared<const MeshShape>(scenes::torus(12, 6, 0.25));
    const auto cube = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    int number_count = 0;
    for (int i = 0; i < 20; ++i) {
        Pose pose = random.turned();
        pose.t = random.direction() * random.uniform(3, 5);
        const Vec3 motion = -1.25 * pose.t + random.direction();
        const Posed<Rounded> x(rounded(cube, 0.25), pose);
        const Posed<MeshShape> y(*ring, Pose());
        const auto contact = cast(x, motion, y);
        if (!contact || contact->time <= 0) continue;
        const auto expected = expected_of({*cube, pose}, 0.25, motion, y, 0, *contact);
        if (expected) number_count += compare_with(*expected, contact_point(x, motion, y, *contact));
    }
    EXPECT_GT(number_count, 50);
}

}  // namespace
}  // namespace ecods
