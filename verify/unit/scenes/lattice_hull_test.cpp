// Hulls on the lattice, and the polytopes that fly in a box.
#include "scenes/lattice_hull.hpp"

#include <gtest/gtest.h>

#include "oracle/solid.hpp"
#include "scenes/convex_cases.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/moving_polytopes.hpp"

namespace ecods {
namespace {

using scenes::hard::Int3;

Int3 wide(const scenes::LatticePoint& p) {
    return {p[0], p[1], p[2]};
}

// Every point is on the inner side of every triangle, in integers.
void expect_around(const scenes::LatticeMesh& mesh, std::span<const scenes::LatticePoint> points) {
    for (const Triangle& t : mesh.triangles) {
        const Int3 p = wide(mesh.vertices[t[0]]), q = wide(mesh.vertices[t[1]]), r = wide(mesh.vertices[t[2]]);
        const Int3 normal = scenes::hard::cross(scenes::hard::minus(q, p), scenes::hard::minus(r, p));
        for (const scenes::LatticePoint& x : points) {
            ASSERT_LE(scenes::hard::dot(normal, scenes::hard::minus(wide(x), p)), 0);
        }
    }
}

TEST(LatticeHull, IsClosedAndAroundItsPoints) {
    scenes::Random random(1);
    for (int i = 0; i < 200; ++i) {
        std::vector<scenes::LatticePoint> points(4 + random.below(12));
        const int size = scenes::hard::integer(random, 1, 4);
        for (auto& p : points) {
            for (int& x : p) x = scenes::hard::integer(random, -size, size);
        }
        scenes::LatticeMesh mesh = scenes::lattice_hull(points);
        if (mesh.triangles.empty()) continue;
        ASSERT_NO_FATAL_FAILURE(expect_around(mesh, points));
        for (int times = 0; times < 2; ++times) {
            const auto made = scenes::to_mesh(mesh, 1);
            ASSERT_FALSE(oracle::open_edge(*made));
            ASSERT_TRUE(oracle::self_intersections(*made).empty());
            mesh = scenes::refined(mesh);
        }
    }
}

TEST(LatticeHull, OfPointsInOnePlaneIsNone) {
    const std::vector<scenes::LatticePoint> points{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {3, 3, 1}, {1, 1, 1}};
    EXPECT_TRUE(scenes::lattice_hull(points).triangles.empty());
    EXPECT_TRUE(scenes::lattice_hull({}).triangles.empty());
}

TEST(MovingPolytopes, StayInTheirBoxAndHaveFiftyFaces) {
    scenes::MovingPolytopes polytopes({.count = 60});
    double furthest = 0;
    for (int frame = 0; frame < 200; ++frame) polytopes.step();
    for (const Pose& pose : polytopes.poses()) furthest = std::max(furthest, pose.t.cwiseAbs().maxCoeff());
    EXPECT_GT(furthest, 7);
    EXPECT_LT(furthest, 8.6);
    for (const auto& mesh : polytopes.meshes()) EXPECT_EQ(mesh->triangles().size(), 50U);
}

}  // namespace
}  // namespace ecods
