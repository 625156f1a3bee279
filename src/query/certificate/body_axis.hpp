// Projects the boxes and triangles of a posed tree onto an axis, with proven error bounds.
//
// With a tree's frame v = center + map y, the coordinate of a point along n, relative to `base`, is
//     n . (R v + t - base) = p . y + q,   p = map^T R^T n,   q = n . (R center + d),   d = fl(t - base).
// Bound, in doubles, with u' = 2^-52 for one operation in any rounding mode: let w = |n| |R| |map| 1 and w_d = |n| (|R|
// |center| + |d|). R map is off by 3.01 u' times its sum of magnitudes, and p by as much again. So p . y, with |y| <= 1
// + 2^-22, is off by 6.2 u' w. q is off by 8.2 u' w_d, the rounding of d included. The middle and the half width of a
// box each have the error of p . y, and 3.01 u' w of products and sums. To add q, and to compute the two ends, takes
// less than 3 u' (w + w_d). Together this is below 22 u' w + 12 u' w_d; 32 u' (w + w_d) also covers the evaluation of
// these sums. The corners of a leaf have an additional error of corner_error on each axis.
//
// Underflow: all sums that enter are required to be below 2^300, and w + w_d above 2^-300. A hundred operations lose
// 2^-1022 each, also if subnormals count as zero, times factors below 2^600: less than a hundredth of u' w.
// Claim: verify/proofs/posed_axes.py
#pragma once

#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/point/frame.hpp"
#include "query/certificate/part_reaches.hpp"

namespace ecods {

// BodyFrame holds the numbers of a posed mesh that do not depend on the axis; the comments name them as the derivation
// above does.
struct BodyFrame {
    // Coordinates are relative to `base`. The pose and the shape that `body` refers to must outlive this object.
    BodyFrame(const Posed<MeshShape>& body, const Vec3& base);

    exact::BodyRef ref;
    const MeshBvh& tree;
    Vec3 offset;       // d
    Mat3 edges;        // R map
    Vec3 origin;       // R center + d
    Vec3 size;         // |R| |map| 1
    Vec3 origin_size;  // |R| |center| + |d|
    bool is_bounded;

    const Triangle& triangle(std::uint32_t i) const { return ref.mesh->triangles()[i]; }
    // Returns the posed vertex, rounded, without an error bound.
    Vec3 at(std::uint32_t vertex) const { return ref.pose->R * ref.mesh->vertices()[vertex] + offset; }
    // Returns the normals of the tree's boxes in the world, as columns; the world's axes if the pose is nearly
    // singular.
    Mat3 normals() const;
};

BodyAxis put_on_axis(const BodyFrame& body, const Vec3& n);

// Sets `reaches` to the intervals of the boxes or triangles of x along the axis. The intervals are not enlarged by
// axis.error.
template <class X>
void find_reaches(const BodyAxis& axis, const X& x, Reaches<double>& reaches) noexcept;

// Returns the direction scaled so that its largest coordinate is between 1 and 2, with each coordinate rounded to a
// multiple of 2^-bits. Returns zero if the direction is zero, NaN, or out of range.
Vec3 shortened(const Vec3& direction, int bits = 16);

}  // namespace ecods
