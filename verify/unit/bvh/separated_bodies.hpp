// Bodies with trees, and which of their triangles the walk from the roots lets through: what is never to be separated.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <memory>
#include <utility>
#include <vector>

#include "bvh/axes/separating_axes.hpp"
#include "ecods/ids.hpp"
#include "ecods/predicates.hpp"
#include "environment/instruction_sets.hpp"

namespace ecods {

inline MeshBvh build(const Mesh& mesh) {
    return build_mesh_bvh(mesh, fit_frame(mesh));
}

inline constexpr std::array rounding_modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

struct Body {
    std::shared_ptr<const Mesh> mesh;
    MeshBvh tree;
    Pose pose;

    Body(std::shared_ptr<const Mesh> m, const Pose& p) : mesh(std::move(m)), tree(build(*mesh)), pose(p) {}
};

// overlap_mask(), once it is the same for every instruction set.
template <class X, class Y>
std::uint64_t near_lanes_of_all(const std::array<AxisSet, 2>& sets, const X& x, const Y& y) {
    const std::uint64_t near = overlap_mask(sets, x, y);
    for (const InstructionSet set : environment::supported_instruction_sets()) {
        const environment::InstructionSetLimit limit(set);
        EXPECT_EQ(overlap_mask(sets, x, y), near) << environment::name(set);
    }
    return near;
}

// Whether the trees let triangles i and j through, from the roots down.
inline bool let_through(const Body& a, const Body& b, std::uint32_t i, std::uint32_t j) {
    SeparatingAxes axes;
    if (axes.bind({a.tree, a.pose.R}, {b.tree, b.pose.R}, b.pose.t - a.pose.t) >= 0) return false;
    const auto& sets = axes.sets();
    std::vector<std::pair<TreeRef, TreeRef>> open{{a.tree.root, b.tree.root}};
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        const auto visit = [&](std::uint64_t near, const auto& below_x, const auto& below_y) {
            for (std::size_t bit = 0; bit < 64; ++bit) {
                if (near >> bit & 1) open.emplace_back(below_x(bit % 8), below_y(bit / 8));
            }
        };
        const auto x_itself = [&](std::size_t) { return x; };
        const auto y_itself = [&](std::size_t) { return y; };
        const auto x_child = [&](std::size_t lane) { return a.tree.nodes[x.index()].child[lane]; };
        const auto y_child = [&](std::size_t lane) { return b.tree.nodes[y.index()].child[lane]; };
        if (x.is_leaf() && y.is_leaf()) {
            const TreeLeaf &p = a.tree.leaves[x.index()], &q = b.tree.leaves[y.index()];
            const std::uint64_t near = near_lanes_of_all(sets, p, q);
            for (std::size_t bit = 0; bit < 64; ++bit) {
                if (near >> bit & 1 && p.triangle[bit % 8] == i && q.triangle[bit / 8] == j) return true;
            }
        } else if (x.is_leaf()) {
            visit(near_lanes_of_all(sets, a.tree.leaves[x.index()], b.tree.nodes[y.index()]), x_itself, y_child);
        } else if (y.is_leaf()) {
            visit(near_lanes_of_all(sets, a.tree.nodes[x.index()], b.tree.leaves[y.index()]), x_child, y_itself);
        } else {
            visit(near_lanes_of_all(sets, a.tree.nodes[x.index()], b.tree.nodes[y.index()]), x_child, y_child);
        }
    }
    return false;
}

inline bool let_through_in_every_rounding_mode(const Body& a, const Body& b, std::uint32_t i, std::uint32_t j) {
    bool all = true;
    for (const int mode : rounding_modes) {
        std::fesetround(mode);
        all = all && let_through(a, b, i, j) && let_through(b, a, j, i);
    }
    std::fesetround(FE_TONEAREST);
    return all;
}

// The pairs of triangles that share a point, without a tree.
inline std::vector<TrianglePair> pairs_of(const Body& a, const Body& b) {
    std::vector<TrianglePair> pairs;
    for (std::uint32_t i = 0; i < a.mesh->triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.mesh->triangles().size(); ++j) {
            const auto corners = [](const Body& body, std::uint32_t t) {
                const Triangle& indices = body.mesh->triangles()[t];
                const auto v = body.mesh->vertices();
                return std::array<Vec3, 3>{v[indices[0]], v[indices[1]], v[indices[2]]};
            };
            if (triangle_triangle({a.pose, corners(a, i)}, {b.pose, corners(b, j)}) != Relation::disjoint) {
                pairs.push_back({i, j});
            }
        }
    }
    return pairs;
}

// Moves b towards a along a line until the last double at which they still touch: a contact that is as thin as can be.
// The line begins at `start`, where they touch.
inline void bring_into_contact(const Body& a, Body& b, const Vec3& direction, const Vec3& start) {
    double touching = 0, apart = 8;
    for (int i = 0; i < 70; ++i) {
        const double middle = 0.5 * touching + 0.5 * apart;
        b.pose.t = start + middle * direction;
        (pairs_of(a, b).empty() ? apart : touching) = middle;
    }
    b.pose.t = start + touching * direction;
}
inline void bring_into_contact(const Body& a, Body& b, const Vec3& direction) {
    bring_into_contact(a, b, direction, a.pose.t);
}

}  // namespace ecods
