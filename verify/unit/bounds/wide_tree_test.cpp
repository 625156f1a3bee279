#include "bounds/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods {
namespace {

bool is_inside(const TreeNode& node, const Vec3& v) {
    for (int k = 0; k < 3; ++k) {
        // Exact: the differences of numbers of 21 bits are.
        if (std::abs(v[k] - node.center[k]) > node.half[k]) return false;
    }
    return true;
}

// Every node contains the triangles below it; every triangle is in one leaf.
void expect_sound(const Mesh& mesh) {
    const TriangleTree tree = build_triangle_tree(mesh);
    std::vector<std::uint32_t> order = tree.order;
    std::ranges::sort(order);
    std::vector<std::uint32_t> all(mesh.triangles().size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(order, all);

    std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> open{{0, {}}};
    std::size_t leaf_triangles = 0;
    while (!open.empty()) {
        auto [index, above] = open.back();
        open.pop_back();
        above.push_back(index);
        const TreeNode& node = tree.nodes[index];
        if (!node.is_leaf()) {
            open.push_back({node.begin, above});
            open.push_back({node.begin + 1, above});
            continue;
        }
        EXPECT_LE(node.count, TriangleTree::leaf_size);
        leaf_triangles += node.count;
        for (std::uint32_t i = node.begin; i < node.begin + node.count; ++i) {
            for (const std::uint32_t corner : mesh.triangles()[tree.order[i]]) {
                for (const std::uint32_t ancestor : above) {
                    ASSERT_TRUE(is_inside(tree.nodes[ancestor], mesh.vertices()[corner]));
                }
            }
        }
    }
    EXPECT_EQ(leaf_triangles, mesh.triangles().size());
}

TEST(TriangleTree, IsSound) {
    expect_sound(*scenes::cube(0.5));
    expect_sound(*scenes::ship());
    expect_sound(*scenes::torus(30, 20, 0.25));
    expect_sound(*Mesh::create({{1, 1, 1}}, {{0, 0, 0}}));
    expect_sound(*Mesh::create({{1, 1, 1}}, std::vector<Triangle>(100, Triangle{0, 0, 0})));
}

}  // namespace
}  // namespace ecods
