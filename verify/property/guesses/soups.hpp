// The bodies of a case as the oracle and the trees see them.
#pragma once

#include <array>
#include <vector>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/walks/walk_two.hpp"
#include "oracle/distance.hpp"
#include "property/guesses/bodies.hpp"
#include "property/guesses/check.hpp"

namespace ecods::guesses {

inline oracle::Soup soup_of(const Mesh& mesh, const Pose& pose) {
    return {mesh.vertices(), mesh.triangles(), pose};
}
inline oracle::Soup soup_of(const Mesh& mesh, const Pose& pose, std::uint32_t triangle) {
    return {mesh.vertices(), mesh.triangles().subspan(triangle, 1), pose};
}

// Both bodies with trees, each built in a mode of its own.
struct Trees {
    Bodies bodies;
    std::uint32_t count_a, count_b;
    MeshBvh a, b;

    Trees(Random& random, std::uint32_t triangle_max)
        : bodies(some_bodies(random, triangle_max)),
          count_a(static_cast<std::uint32_t>(bodies.a->triangles().size())),
          count_b(static_cast<std::uint32_t>(bodies.b->triangles().size())),
          a(in_mode(some_mode(random), [&] { return build_mesh_bvh(*bodies.a, fit_frame(*bodies.a)); })),
          b(in_mode(some_mode(random), [&] { return build_mesh_bvh(*bodies.b, fit_frame(*bodies.b)); })) {}

    PosedTree posed_a() const { return {a, bodies.pose_a.R}; }
    PosedTree posed_b() const { return {b, bodies.pose_b.R}; }
    Vec3 d() const { return bodies.pose_b.t - bodies.pose_a.t; }
    std::size_t pair_count() const { return std::size_t{count_a} * count_b; }
    std::size_t number(std::uint32_t i, std::uint32_t j) const { return std::size_t{i} * count_b + j; }

    // Whether the walk from the roots comes to each pair of triangles, with this mask of nodes and leaves.
    template <class Mask>
    std::vector<bool> reached(const Mask& mask) const {
        std::vector<bool> result(pair_count());
        std::vector<NodePair> stack;
        walk_two(a, b, stack, mask, [&](std::uint32_t i, std::uint32_t j) {
            result[number(i, j)] = true;
            return true;
        });
        return result;
    }
};

template <class X, class Y>
inline constexpr bool both_leaves = std::is_same_v<X, TreeLeaf>&& std::is_same_v<Y, TreeLeaf>;

}  // namespace ecods::guesses
