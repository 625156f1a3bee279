// The oracle's answers for meshes and boxes, against its own for triangles and against answers known beforehand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "oracle/oracle.hpp"

namespace ecods::oracle::oracle_mesh_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::shared_ptr<const Mesh> random_soup(std::mt19937_64& random, int triangle_count, double unit) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (int i = 0; i < triangle_count; ++i) {
        const Vec3 origin(static_cast<double>(random() % 8), static_cast<double>(random() % 8),
                          static_cast<double>(random() % 8));
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (int k = 0; k < 3; ++k) {
            const Vec3 offset(static_cast<double>(random() % 3), static_cast<double>(random() % 3),
                              static_cast<double>(random() % 3));
            vertices.push_back((origin + offset) * unit);
        }
        triangles.push_back({first, first + 1, first + 2});
    }
    return Mesh::create(vertices, triangles);
}

std::array<Vec3, 3> corners(const Mesh& mesh, std::size_t triangle) {
    const Triangle& t = mesh.triangles()[triangle];
    return {mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]};
}

void expect_all_pairs(const std::shared_ptr<const Mesh>& a, const Pose& pose_a, const std::shared_ptr<const Mesh>& b,
                      const Pose& pose_b) {
    std::vector<TrianglePair> expected;
    Relation strongest = Relation::apart;
    for (std::uint32_t i = 0; i < a->triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b->triangles().size(); ++j) {
            const Relation relation = triangle_triangle(pose_a, corners(*a, i), pose_b, corners(*b, j));
            if (relation != Relation::apart) expected.push_back({i, j});
            strongest = std::max(strongest, relation);
        }
    }
    const OracleMesh mesh_a(a, pose_a);
    const OracleMesh mesh_b(b, pose_b);
    EXPECT_TRUE(intersecting_triangles(mesh_a, mesh_b) == expected);
    EXPECT_TRUE(verdict(mesh_a, mesh_b).triangles == expected);
    EXPECT_EQ(verdict(mesh_a, mesh_b).relation, strongest);
    EXPECT_EQ(relation(mesh_a, mesh_b), strongest);
    EXPECT_EQ(relation(mesh_b, mesh_a), strongest);
    EXPECT_EQ(intersects(mesh_a, mesh_b), strongest != Relation::apart);
    EXPECT_EQ(intersecting_triangles(mesh_b, mesh_a).size(), expected.size());
}

TEST(OracleMesh, FindsAllPairsOfTriangles) {
    std::mt19937_64 random(5);
    Pose rotated;
    rotated.R = Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized().matrix();
    rotated.t = Vec3(1, 2, -1);
    // The last unit takes boxes to where their ends are infinite.
    for (const double unit : {1.0, 0.1, std::ldexp(1.0, 1020)}) {
        const auto a = random_soup(random, 60, unit);
        const auto b = random_soup(random, 80, unit);
        expect_all_pairs(a, {}, b, {});
        expect_all_pairs(a, rotated, b, rotated);
        expect_all_pairs(a, {}, b, rotated);
    }
    Pose large;
    large.R *= std::ldexp(1.0, 900);
    const auto a = random_soup(random, 30, std::ldexp(1.0, 500));
    expect_all_pairs(a, large, a, large);
}

TEST(OracleMesh, DisjointMeshesHaveNoPairs) {
    const auto mesh = Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    Pose above;
    above.t = Vec3(0, 0, std::numeric_limits<double>::denorm_min());
    const OracleMesh a(mesh, {});
    const OracleMesh b(mesh, above);
    EXPECT_EQ(relation(a, b), Relation::apart);
    EXPECT_FALSE(intersects(a, b));
    EXPECT_TRUE(intersecting_triangles(a, b).empty());
    EXPECT_EQ(relation(a, a), Relation::touching);  // coplanar
}

TEST(OracleBox, ContainsExactlyWhatItContains) {
    // Vertex 3 is in no triangle, so the box need not hold it.
    const auto mesh = Mesh::create({{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 3}, {9, 9, 9}}, {{0, 1, 2}});
    Pose pose;
    pose.R *= 3;
    // 3 * 0.1 lies strictly between two neighbouring doubles: its rounded value is below or above it.
    const double below = std::nextafter(0.1 * 3, 0.0);
    const double above = std::nextafter(0.1 * 3, 1.0);
    const OracleMesh posed(mesh, pose);
    EXPECT_TRUE(box_contains({Vec3(0, 0, 0), Vec3(above, above, 9)}, posed));
    EXPECT_FALSE(box_contains({Vec3(0, 0, 0), Vec3(below, above, 9)}, posed));
    EXPECT_FALSE(box_contains({Vec3(0, 0, 0), Vec3(above, above, std::nextafter(9.0, 0.0))}, posed));
    EXPECT_FALSE(box_contains({Vec3(0, std::numeric_limits<double>::denorm_min(), 0), Vec3(above, above, 9)}, posed));
    EXPECT_TRUE(box_contains({Vec3::Constant(-infinity), Vec3::Constant(infinity)}, posed));
    EXPECT_TRUE(box_contains(posed.outer_box(), posed));
    // One of the two neighbours of the product holds it, the other does not: the exact value is 0.3 + 2^-54 * 0.4...
    const bool nearest_holds = std::fma(3.0, 0.1, -(0.1 * 3)) <= 0;
    EXPECT_EQ(box_contains({Vec3(0, 0, 0), Vec3(0.1 * 3, 0.1 * 3, 9)}, posed), nearest_holds);
}

TEST(OracleBox, HandlesCoordinatesBeyondTheLargestDouble) {
    const auto mesh = Mesh::create({{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}, {{0, 1, 2}});
    Pose pose;
    pose.R *= 1e300;
    const OracleMesh posed(mesh, pose);
    const double largest = std::numeric_limits<double>::max();
    EXPECT_FALSE(box_contains({Vec3::Constant(-largest), Vec3::Constant(largest)}, posed));
    EXPECT_TRUE(box_contains({Vec3::Zero(), Vec3(infinity, infinity, 0)}, posed));
}

TEST(OracleBox, OverlapIsClosed) {
    const std::vector<Aabb> boxes{{Vec3(0, 0, 0), Vec3(1, 1, 1)},
                                  {Vec3(1, 0, 0), Vec3(2, 1, 1)},
                                  {Vec3(std::nextafter(1.0, 2.0), 1, 1), Vec3(infinity, 1, 1)},
                                  {Vec3(5, 5, 5), Vec3(5, 5, 5)}};
    using Pair = std::pair<std::size_t, std::size_t>;
    EXPECT_EQ(overlapping_boxes(boxes), (std::vector<Pair>{{0, 1}, {1, 2}}));
}

}  // namespace
}  // namespace ecods::oracle::oracle_mesh_test
