// A body with its tree, and which of the triangles of two of them the walk from the roots lets through.
#pragma once

#include <array>
#include <cfenv>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/walks/walk_two.hpp"
#include "ecods/primitives.hpp"
#include "oracle/distance.hpp"
#include "unit/bvh/mask_of_all.hpp"

namespace ecods {

inline constexpr std::array rounding_modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

inline MeshBvh build(const Mesh& mesh) {
    return build_mesh_bvh(mesh, fit_frame(mesh));
}

struct Body {
    std::shared_ptr<const Mesh> mesh;
    MeshBvh tree;
    Pose pose;

    explicit Body(std::shared_ptr<const Mesh> m, const Pose& p = {})
        : mesh(std::move(m)), tree(build(*mesh)), pose(p) {}

    PosedTree posed() const { return {tree, pose.R}; }
    oracle::Soup soup() const { return {mesh->vertices(), mesh->triangles(), pose}; }
    oracle::Soup soup_of(std::uint32_t triangle) const {
        return {mesh->vertices(), mesh->triangles().subspan(triangle, 1), pose};
    }
    PosedTriangle posed_triangle(std::uint32_t triangle) const {
        const Triangle& t = mesh->triangles()[triangle];
        return {pose, {mesh->vertices()[t[0]], mesh->vertices()[t[1]], mesh->vertices()[t[2]]}};
    }
};

// Whether the trees let triangles i and j through to the leaves, from the roots down, with this mask of nodes and
// leaves.
template <class Mask>
bool let_through(const Body& a, const Body& b, const Mask& mask, std::uint32_t i, std::uint32_t j) {
    std::vector<NodePair> stack;
    bool found = false;
    walk_two(a.tree, b.tree, stack, MaskBound{mask}, [&](std::uint32_t p, std::uint32_t q) {
        found = found || (p == i && q == j);
        return !found;
    });
    return found;
}

}  // namespace ecods
