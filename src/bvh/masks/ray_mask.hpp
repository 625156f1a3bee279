// A TreeRay tests a ray along an axis of the world, or a point, against the boxes of a posed tree.
//
// A row is a linear function of points, given by a vector n of the world. A point of the mesh with the coordinates y is
// R (center + map y) + t. Relative to the ray's beginning p, the row's value there is
//
//     n . (R (center + map y) + t - p) = shift + g . y,    g = (R map)^T n,    shift = n . (R center - (p - t)).
//
// The vectors n of the rows `across` are perpendicular to the ray: the ray meets a box only if each of these rows is
// zero somewhere in the box. If n is the cross product of the ray's direction and an edge of the boxes, the row bounds
// the projection of a box along the ray exactly. The row `along` has n = the ray's direction: if it is negative in the
// whole box, the box is behind the ray. For a point, the rows across are the axes of the world, and the row along
// excludes nothing.
//
// Bound, for numbers in a unit, a power of two, in which the largest entry of R map is about one (exact). In any
// rounding mode one operation has an error of u' = 2^-52 (base/arithmetic.hpp). Boxes have |center| + half <= 1 +
// 2^-21.
//
// Doubles. Let M = |R| |map| and W = |R| |center| + |p - t|. R map as computed is off by 3.01 u' M. R center - (p - t)
// is off by 5.1 u' W + origin_error, if p - t is given with an error of u' |p - t| + origin_error. Edges as computed
// serve as exact vectors n, since any n is sound. Products and sums of a row add 3.01 u' |n| (W + M). All this is below
// 9 u' (|n| . W + sum (|n| M)) + origin_error sum |n|; 16 in place of 9 covers the evaluation of the bound.
//
// Floats. Let v = 2^-23. g and shift are off by v each when they are converted, a product by v and three sums by v
// each: 5.1 v (|shift| + sum |g|) for shift + g . center, and as much for |g| . half. A triangle's corner is off by
// corner_error < 2.01 v of a unit. All errors together are below 16 v (|shift| + sum |g|).
//
// Underflow. Each operation on doubles loses 2^-1022 times a factor, which is checked to be below 2^500: a hundred
// operations lose less than 2^-400. Each operation on floats loses 2^-126. 2^-100 is added. If a check fails, the
// margin is infinite, and no box is excluded.
// Claim: verify/proofs/posed_axes.py
#pragma once

#include <array>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/pose.hpp"

namespace ecods {

struct RayRow {
    std::array<float, 3> g;
    std::array<float, 3> size;  // |g|
    float shift;
    float margin;
};

struct TreeRay {
    std::array<RayRow, 3> across;
    RayRow along;
    int axis = 0;
    int sign = 1;  // 1 if the ray goes up, -1 if down
};

// Holds the beginning of a ray relative to a tree: p - t, where t is the translation of the tree's pose. Each
// coordinate of `offset` is off by at most u' times its magnitude, plus `error`.
struct RayOrigin {
    Vec3 offset;
    double error;
};

// Sets `ray` to one of the rays up and down along the axes in `axes` (bits 0 to 2, at least one): to the ray that
// leaves the tree's root soonest, relative to the root's size. Returns false, without a ray, if the beginning is
// certainly outside of the root's box on an axis of the world: then every ray that leads away from the box misses it.
bool set_ray(TreeRay& ray, const MeshBvh& tree, const Mat3& R, const RayOrigin& origin, std::uint32_t axes);

// Sets `point` to a test of the point `origin`. Returns false if the point is certainly outside of the root's box.
bool set_point(TreeRay& point, const MeshBvh& tree, const Mat3& R, const RayOrigin& origin);

// Returns a mask of the lanes that the ray may meet. Bits of lanes that repeat another lane are clear.
std::uint32_t ray_mask(const TreeRay& ray, const BvhNode& node) noexcept;
std::uint32_t ray_mask(const TreeRay& ray, const TreeLeaf& leaf) noexcept;

}  // namespace ecods
