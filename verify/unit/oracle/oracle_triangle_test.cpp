// The oracle's answer for two triangles against the model.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cfenv>
#include <cmath>
#include <random>
#include <vector>

#include "convex_pair.hpp"
#include "oracle/oracle.hpp"

namespace ecods::oracle::oracle_triangle_test {
namespace {

using Corners = std::array<Vec3, 3>;

Vec3 random_lattice_point(std::mt19937_64& random, const std::array<int, 3>& sizes) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis)
        point[axis] = static_cast<double>(random() % static_cast<unsigned>(sizes[axis]));
    return point;
}

Corners random_triangle(std::mt19937_64& random, const std::array<int, 3>& sizes) {
    return {random_lattice_point(random, sizes), random_lattice_point(random, sizes),
            random_lattice_point(random, sizes)};
}

Corners scaled(const Corners& corners, double factor) {
    return {corners[0] * factor, corners[1] * factor, corners[2] * factor};
}

struct Counts {
    std::array<int, 3> of_relation{};
    int differing = 0;
};

void compare(const Pose& pose_a, const Corners& a, const Pose& pose_b, const Corners& b, Counts& counts) {
    const Relation expected = model::relation(pose_a, a, pose_b, b);
    ++counts.of_relation[static_cast<std::size_t>(expected)];
    const bool same = triangle_triangle(pose_a, a, pose_b, b) == expected &&
                      triangle_triangle(pose_b, {b[2], b[0], b[1]}, pose_a, {a[1], a[0], a[2]}) == expected;
    if (!same) ++counts.differing;
}

// All pairs of the triangles with corners in {0,1}^3, repeated corners included.
TEST(OracleTriangle, AgreesWithModelOnAllOfTheUnitCube) {
    std::vector<Corners> triangles;
    const auto corner = [](int i) { return Vec3(i & 1, i >> 1 & 1, i >> 2 & 1); };
    for (int i = 0; i < 8; ++i) {
        for (int j = i; j < 8; ++j) {
            for (int k = j; k < 8; ++k) triangles.push_back({corner(i), corner(j), corner(k)});
        }
    }
    Counts counts;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t j = i; j < triangles.size(); ++j) compare({}, triangles[i], {}, triangles[j], counts);
    }
    EXPECT_EQ(counts.differing, 0);
    for (const int count : counts.of_relation) EXPECT_GT(count, 10);
}

TEST(OracleTriangle, AgreesWithModelOnLattices) {
    std::mt19937_64 random(1);
    // Space, a plane, a line: the latter two are all coplanar or all of zero area.
    for (const std::array<int, 3> sizes :
         {std::array{3, 3, 3}, std::array{4, 4, 4}, std::array{4, 4, 1}, std::array{1, 5, 5}, std::array{4, 1, 1}}) {
        Counts counts;
        for (int i = 0; i < 500; ++i) {
            compare({}, random_triangle(random, sizes), {}, random_triangle(random, sizes), counts);
        }
        EXPECT_EQ(counts.differing, 0) << sizes[0] << sizes[1] << sizes[2];
        EXPECT_GT(counts.of_relation[0], 10);
        EXPECT_GT(counts.of_relation[1], 10);
    }
}

TEST(OracleTriangle, AgreesWithModelUnderPoses) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Counts common;
    Counts singular;
    for (int i = 0; i < 150; ++i) {
        const Corners a = random_triangle(random, {3, 3, 3});
        const Corners b = random_triangle(random, {3, 3, 3});
        Pose pose;
        pose.R = Eigen::Quaterniond(uniform(random), uniform(random), uniform(random), 1).normalized().matrix();
        pose.t = Vec3(uniform(random), uniform(random), uniform(random));
        compare(pose, a, pose, b, common);
        // The image lies in a plane, as one row of the matrix is a multiple of another.
        pose.R.row(2) = pose.R.row(i % 2) * (i % 3 - 1.0);
        Pose other = pose;
        other.R.col(0).swap(other.R.col(1));
        compare(pose, a, other, b, singular);
    }
    EXPECT_EQ(common.differing, 0);
    EXPECT_EQ(singular.differing, 0);
    for (const int count : common.of_relation) EXPECT_GT(count, 5);
    EXPECT_EQ(singular.of_relation[2], 0);
    EXPECT_GT(singular.of_relation[1], 5);
}

// What a common matrix and a power of two do not change: from products beyond the largest double down to subnormals.
TEST(OracleTriangle, AgreesWithModelAtTheEndsOfTheRange) {
    std::mt19937_64 random(3);
    for (const int exponent : {1020, 600, 100, -500, -1070}) {
        Counts counts;
        Pose pose;
        if (exponent == 1020) pose.R *= std::ldexp(1.0, 1000);
        if (exponent == -1070) pose.R *= std::ldexp(1.0, -1000);
        for (int i = 0; i < 150; ++i) {
            const Corners a = random_triangle(random, {3, 3, 3});
            const Corners b = random_triangle(random, {3, 3, 3});
            const Relation expected = model::relation({}, a, {}, b);
            ++counts.of_relation[static_cast<std::size_t>(expected)];
            const double factor = std::ldexp(1.0, exponent);
            if (triangle_triangle(pose, scaled(a, factor), pose, scaled(b, factor)) != expected) ++counts.differing;
        }
        EXPECT_EQ(counts.differing, 0) << exponent;
        for (const int count : counts.of_relation) EXPECT_GT(count, 5);
    }
}

TEST(OracleTriangle, TellsASegmentThatPiercesFromOneThatTouches) {
    const Corners triangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const auto with = [&](const Vec3& from, const Vec3& to) {
        return triangle_triangle({}, triangle, {}, {from, to, from});
    };
    EXPECT_EQ(with({1, 1, -1}, {1, 1, 1}), Relation::crossing);
    EXPECT_EQ(with({1, 1, 0}, {1, 1, 1}), Relation::touching);   // its end lies in the triangle
    EXPECT_EQ(with({2, 2, -1}, {2, 2, 1}), Relation::touching);  // it passes through an edge
    EXPECT_EQ(with({1, 1, 0}, {2, 1, 0}), Relation::touching);   // it lies in the triangle
    EXPECT_EQ(with({3, 3, -1}, {3, 3, 1}), Relation::apart);
}

// The environment is the caller's: it does not matter, and stays.
TEST(OracleTriangle, IsIndependentOfTheRoundingMode) {
    Pose pose;
    pose.R = Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized().matrix();
    pose.t = Vec3(0.1, 0.2, 0.3);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
        std::mt19937_64 random(4);
        std::fesetround(mode);
        int differing = 0;
        for (int i = 0; i < 50; ++i) {
            const Corners a = random_triangle(random, {3, 3, 3});
            const Corners b = random_triangle(random, {3, 3, 3});
            const Relation expected = model::relation({}, a, {}, b);
            if (triangle_triangle(pose, a, pose, b) != expected) ++differing;
        }
        EXPECT_EQ(std::fegetround(), mode);
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(differing, 0) << mode;
    }
}

}  // namespace
}  // namespace ecods::oracle::oracle_triangle_test
