// The way straight down two trees to triangles that may be nearest, for meshes of every small size.
#include <gtest/gtest.h>

#include "query/distance/distance_question.hpp"

namespace ecods::dive_test {
namespace {

// Triangles one after the other along the first axis.
MeshShape row(std::uint32_t count) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = i;
        vertices.insert(vertices.end(), {Vec3(x, 0, 0), Vec3(x + 0.5, 1, 0), Vec3(x + 0.5, 0, 1)});
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return MeshShape(Mesh::create(std::move(vertices), std::move(triangles)));
}

TrianglePair dive(const MeshShape& a, const MeshShape& b, const Pose& pose_b, QueryCounts& counts) {
    const Pose pose_a;
    const MeshPair bodies{MeshBody(a, pose_a), MeshBody(b, pose_b)};
    DistanceQuestion question;
    question.bind(bodies, counts);
    return question.dive(bodies);
}

// How many nodes are above a triangle.
std::uint64_t depth_of(const MeshBvh& tree, std::uint32_t triangle) {
    std::vector<std::pair<TreeRef, std::uint64_t>> open{{tree.root, 0}};
    while (!open.empty()) {
        const auto [ref, depth] = open.back();
        open.pop_back();
        if (!ref.is_leaf()) {
            const BvhNode& node = tree.nodes[ref.index()];
            for (std::size_t i = 0; i < node.count; ++i) open.emplace_back(node.child[i], depth + 1);
        } else if (std::ranges::find(tree.leaves[ref.index()].triangle, triangle) !=
                   tree.leaves[ref.index()].triangle.end()) {
            return depth;
        }
    }
    ADD_FAILURE() << "no leaf has triangle " << triangle;
    return 0;
}

TEST(Dive, EndsAtTheNearestTrianglesOfTwoRows) {
    for (const std::uint32_t n : {1, 2, 7, 8, 9, 20, 64, 65, 200, 600}) {
        const MeshShape a = row(n);
        for (const std::uint32_t m : {1, 2, 7, 8, 9, 20, 64, 65, 200, 600}) {
            const MeshShape b = row(m);
            QueryCounts counts;
            Pose beyond;
            beyond.t = Vec3(n + 0.25, 0, 0);
            EXPECT_EQ(dive(a, b, beyond, counts), (TrianglePair{n - 1, 0})) << n << ", " << m;
            const MeshBvh &tree_a = MeshShapeAccess::tree(a).boxes, &tree_b = MeshShapeAccess::tree(b).boxes;
            // Both trees are left behind at once: each pair of nodes is opened on the way, and no other.
            EXPECT_EQ(counts.box_tests, std::max(depth_of(tree_a, n - 1), depth_of(tree_b, 0))) << n << ", " << m;
        }
    }
}

TEST(Dive, EndsWhereNoTriangleIsNearerThanOthers) {
    for (const std::uint32_t n : {1, 2, 8, 9, 100}) {
        const MeshShape points(Mesh::create({{1, 1, 1}}, std::vector<Triangle>(n, Triangle{0, 0, 0})));
        for (const std::uint32_t m : {1, 8, 9, 100}) {
            const MeshShape same = row(m);
            for (const double x : {0.0, -3.0}) {
                QueryCounts counts;
                Pose pose;
                pose.t = Vec3(x, 0, 0);
                const TrianglePair found = dive(points, same, pose, counts);
                EXPECT_LT(found.a, n);
                EXPECT_LT(found.b, m);
            }
        }
    }
}

}  // namespace
}  // namespace ecods::dive_test
