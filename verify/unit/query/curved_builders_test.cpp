// Polytopes around curved bodies, beside rational numbers: the planes of their faces, and how far their vertices are.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "ecods/builders.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "environment/each_environment.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"

namespace ecods {
namespace {

using scenes::Random;
using Vector = std::array<mpq_class, 3>;

// Tells whether the body is on the inner side of a plane n.x = d.
using Leaves = bool (*)(const Vector& sizes, const Vector& n, const mpq_class& d);

Vector exact(const Vec3& v) {
    return {mpq_class(v[0]), mpq_class(v[1]), mpq_class(v[2])};
}

mpq_class squared(const mpq_class& x) {
    return x * x;
}

// True if sqrt(square) <= height.
bool reaches(const mpq_class& height, const mpq_class& square) {
    return height >= 0 && square <= height * height;
}

// sizes: radius, height.
bool leaves_cylinder(const Vector& sizes, const Vector& n, const mpq_class& d) {
    const mpq_class up = abs(n[2]) * sizes[1] / 2;
    return reaches(d - up, squared(sizes[0]) * (squared(n[0]) + squared(n[1])));
}

bool leaves_cone(const Vector& sizes, const Vector& n, const mpq_class& d) {
    const mpq_class apex = n[2] * sizes[1] / 2;
    return apex <= d && reaches(d + apex, squared(sizes[0]) * (squared(n[0]) + squared(n[1])));
}

bool leaves_ellipsoid(const Vector& radii, const Vector& n, const mpq_class& d) {
    mpq_class sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += squared(radii[k] * n[k]);
    return reaches(d, sum);
}

void expect_contains(const ConvexSolid& solid, Leaves leaves, const Vector& sizes) {
    const auto v = solid.mesh().vertices();
    for (const Triangle& t : solid.mesh().triangles()) {
        const Vector a = exact(v[t[0]]), b = exact(v[t[1]]), c = exact(v[t[2]]);
        Vector n;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
        }
        EXPECT_TRUE(leaves(sizes, n, n[0] * a[0] + n[1] * a[1] + n[2] * a[2]));
    }
}

// The deviation is the distance of the farthest vertex from the axis, less the radius, rounded up.
void expect_deviation_from_axis(const Circumscribed& made, const mpq_class& radius) {
    mpq_class most = 0;
    for (const Vec3& v : made.solid->mesh().vertices()) {
        const Vector p = exact(v);
        most = std::max<mpq_class>(most, squared(p[0]) + squared(p[1]));
    }
    EXPECT_LE(most, squared(made.deviation + radius));
    EXPECT_GT(made.deviation, 0);
    EXPECT_GT(most, squared(std::nextafter(made.deviation, 0) + radius));
}

// For each vertex p, a point of the ellipsoid between p and the center is no farther than the deviation; and if
// `is_attained`, the vertex on the longest axis is as far.
void expect_deviation_of_ellipsoid(const Circumscribed& made, const Vec3& radii, bool is_attained) {
    const Vector r = exact(radii);
    const mpq_class deviation(made.deviation);
    for (const Vec3& v : made.solid->mesh().vertices()) {
        const Vector p = exact(v);
        mpq_class rho_squared = 0, length_squared = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            rho_squared += squared(p[k] / r[k]);
            length_squared += squared(p[k]);
        }
        // `in` is 1 / rho, rounded down to 300 digits, which moves the point by that much.
        const mpz_class scale = mpz_class(1) << 300;
        mpq_class in(sqrt(mpz_class(mpq_class(scale) * scale / rho_squared)), scale);
        in.canonicalize();
        ASSERT_LE(squared(in) * rho_squared, 1);
        EXPECT_LE(squared(1 - in - mpq_class(1, scale)) * length_squared, squared(deviation));
    }
    if (!is_attained) return;
    int axis = 0;
    radii.maxCoeff(&axis);
    double most = 0;
    for (const Vec3& v : made.solid->mesh().vertices()) most = std::max(most, v[axis] - radii[axis]);
    EXPECT_LE(made.deviation, most + 0x1p-50 * radii[axis]);
}

const std::vector<double> radii_of_discs = {
    1, 0.1, 1.0 / 3, 12345.678, 0x1p500, 0x1.8p-500, 3 * 0x1p-1074, 0x1p-1074, 1000 * 0x1p-1074, 0x1p-1022, 0x1p1020};

TEST(CurvedBuilders, CylindersAndConesAreContained) {
    for (const double radius : radii_of_discs) {
        for (const std::uint32_t sides : {3u, 4u, 5u, 6u, 7u, 8u, 12u, 32u, 101u}) {
            SCOPED_TRACE(std::to_string(radius) + ", " + std::to_string(sides));
            const double height = radius > 1 ? radius : 2 * radius;
            const Vector sizes{mpq_class(radius), mpq_class(height), 0};
            const Circumscribed tube = cylinder(radius, height, sides);
            expect_contains(*tube.solid, leaves_cylinder, sizes);
            expect_deviation_from_axis(tube, mpq_class(radius));
            const Circumscribed hat = cone(radius, height, sides);
            expect_contains(*hat.solid, leaves_cone, sizes);
            EXPECT_EQ(hat.deviation, tube.deviation);
            if (radius < 0x1p-1000) continue;
            EXPECT_EQ(tube.solid->mesh().vertices().size(), 2 * sides);
            EXPECT_EQ(hat.solid->mesh().vertices().size(), sides + 1);
            const double regular = radius * (1 / std::cos(M_PI / sides) - 1);
            EXPECT_NEAR(tube.deviation / radius, regular / radius, 0x1p-49);
        }
    }
}

TEST(CurvedBuilders, ManySides) {
    const Circumscribed tube = cylinder(0.7, 3, 5000);
    expect_contains(*tube.solid, leaves_cylinder, {mpq_class(0.7), 3, 0});
    EXPECT_LT(tube.deviation, 5 * 0.7 / 5000 / 5000);
}

// Four sides, exactly: the least doubles that are outside.
TEST(CurvedBuilders, ASquare) {
    const Circumscribed square = cylinder(1, 2, 4);
    const double root = std::sqrt(2.0);  // rounded up
    for (const Vec3& v : square.solid->mesh().vertices()) {
        EXPECT_EQ(std::abs(v[0]) + std::abs(v[1]), root);
        EXPECT_EQ(std::abs(v[2]), 1);
    }
    EXPECT_EQ(square.deviation, root - 1);
}

TEST(CurvedBuilders, EllipsoidsAreContained) {
    const double tiny = 0x1p-1074;
    const std::vector<Vec3> all = {{1, 1, 1},
                                   {1, 2, 3},
                                   {3, 0.1, 0.7},
                                   {0x1p500, 1, 0x1p-500},
                                   {0x1p-500, 0x1.3p-500, 0x1p-499},
                                   {tiny, 2 * tiny, 5 * tiny},
                                   {0x1p1000, tiny, 1},
                                   {40 * tiny, 1000 * tiny, 0x1p-1022}};
    for (const Vec3& radii : all) {
        for (std::uint32_t subdivisions = 0; subdivisions < 3; ++subdivisions) {
            SCOPED_TRACE(std::to_string(radii[0]) + ", " + std::to_string(subdivisions));
            const Circumscribed made = ellipsoid(radii, subdivisions);
            expect_contains(*made.solid, leaves_ellipsoid, exact(radii));
            const bool is_rounded_finely = radii.minCoeff() > 0x1p-1000;
            expect_deviation_of_ellipsoid(made, radii, subdivisions > 0 && is_rounded_finely);
            if (!is_rounded_finely) continue;
            EXPECT_EQ(made.solid->mesh().vertices().size(), (10u << 2 * subdivisions) + 2);
        }
    }
}

// As the header says, of the longest radius.
TEST(CurvedBuilders, DeviationsOfEllipsoids) {
    double limit[] = {0.2584, 0.07047, 0.01807, 0.00455, 0.001139};
    for (std::uint32_t subdivisions = 0; subdivisions < 5; ++subdivisions) {
        EXPECT_NEAR(ellipsoid({1, 1, 1}, subdivisions).deviation, limit[subdivisions], 0.02 * limit[subdivisions]);
        EXPECT_NEAR(ellipsoid({7, 2, 1}, subdivisions).deviation, 7 * limit[subdivisions], 0.14 * limit[subdivisions]);
    }
}

// The distance of balls is known, and that of the polytopes around them is less by at most the deviations.
TEST(CurvedBuilders, DistancesAreWithinTheDeviations) {
    Random random(7);
    const Circumscribed large = ellipsoid({1, 1, 1}, 3), small = ellipsoid({0.25, 0.25, 0.25}, 2);
    for (int i = 0; i < 200; ++i) {
        const double away = random.uniform(1.5, 4);
        const Vec3 center = away * random.direction();
        Pose pose = random.turned();
        pose.t = center;
        const Pose turned = random.turned();
        const double found = distance({large.solid, turned}, {small.solid, pose});
        const double real = center.norm() - 1.25, slack = 0x1p-48;
        EXPECT_LE(found, real + slack);
        EXPECT_GE(found, real - large.deviation - small.deviation - slack);
    }
}

TEST(CurvedBuilders, AreTheSameInEachEnvironment) {
    const auto digests = [] {
        std::vector<std::uint64_t> all;
        for (const Circumscribed& made :
             {cylinder(0.3, 0.7, 5), cone(0x1p-1070, 1, 4), ellipsoid({0.1, 0x1p-1060, 0x1p-1062}, 0)}) {
            all.push_back(made.solid->digest());
            all.push_back(std::bit_cast<std::uint64_t>(made.deviation));
        }
        return all;
    };
    const auto usual = digests();
    environment::in_each_environment(
        digests, [&](const auto& answer, const std::string& where) { EXPECT_EQ(answer, usual) << where; });
}

TEST(CurvedBuilders, RefuseNumbers) {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
    for (const double bad : {0.0, -0.0, -1.0, -0x1p-1074, nan, infinity, -infinity}) {
        EXPECT_INVALID(cylinder(bad, 1, 8), Argument::size);
        EXPECT_INVALID(cylinder(1, bad, 8), Argument::size);
        EXPECT_INVALID(cone(bad, 1, 8), Argument::size);
        EXPECT_INVALID(ellipsoid({1, 1, bad}, 0), Argument::size);
    }
    EXPECT_INVALID(cone(1, 0x1p-1074, 3), Argument::size);
    EXPECT_INVALID(cylinder(1, 3 * 0x1p-1074, 3), Argument::size);
    EXPECT_INVALID(cylinder(0x1p1023, 1, 3), Argument::size);
    EXPECT_INVALID(ellipsoid({1, 0x1.fp1023, 1}, 0), Argument::size);
    for (const std::uint32_t sides : {0u, 2u, max_sides + 1, ~0u}) {
        EXPECT_INVALID(cylinder(1, 1, sides), Argument::count);
        EXPECT_INVALID(cone(1, 1, sides), Argument::count);
    }
    EXPECT_INVALID(ellipsoid({1, 1, 1}, max_subdivisions + 1), Argument::count);
    try {
        static_cast<void>(ellipsoid({1, -2, 3}, 0));
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.part, "radii(1)");
        EXPECT_EQ(error.value, -2);
    }
    try {
        static_cast<void>(cone(1, 1, 2));
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_STREQ(error.what(), "sides is 2, not from 3 to 16384");
        EXPECT_EQ(error.part, "sides");
    }
}

}  // namespace
}  // namespace ecods
