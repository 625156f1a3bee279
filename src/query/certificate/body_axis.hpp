// Where the parts of a posed tree are along an axis, with proven bounds.
//
// With a tree's frame v = center + map y, the coordinate of a point along n, counted from `base`, is
//     n . (R v + t - base) = p . y + q,   p = map^T R^T n,   q = n . (R center + d),   d = fl(t - base).
// Bound, in doubles, u' = 2^-52 for one operation in any rounding mode: let w = |n| |R| |map| 1 and
// w_d = |n| (|R| |center| + |d|). R map is off by 3.01 u' times its sum of magnitudes, and p by as much again: p . y,
// |y| <= 1 + 2^-22, by 6.2 u' w. q is off by 8.2 u' w_d, the rounding of d included. Middle and reach of a box each
// have that error of p and 3.01 u' w of products and sums; adding q, and the two ends, less than 3 u' (w + w_d).
// Together below 22 u' w + 12 u' w_d; 32 u' (w + w_d) covers the evaluation of the sums, too. A leaf's corners are off
// by corner_error more, on each axis.
//
// Underflow: all of the sums that enter are required to be below 2^300, and w + w_d above 2^-300. A hundred operations
// lose 2^-1022 each, subnormals taken for zero included, times factors below 2^600: less than a hundredth of u' w.
#pragma once

#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/posed.hpp"
#include "ecods/shape.hpp"
#include "exact/point/frame.hpp"
#include "query/certificate/part_reaches.hpp"

namespace ecods {

// What all axes need of a posed mesh.
struct BodyFrame {
    // Points are counted from `base`. What the posed mesh refers to, and its pose, must outlive this.
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
    // The posed vertex, about.
    Vec3 at(std::uint32_t vertex) const { return ref.pose->R * ref.mesh->vertices()[vertex] + offset; }
    // The normals of the boxes in the world, or the axes of the world where the pose is too flat for these. Columns.
    Mat3 normals() const;
};

BodyAxis put_on_axis(const BodyFrame& body, const Vec3& n);

// The reaches of parts; `error` is not included.
template <class X>
void find_reaches(const BodyAxis& axis, const X& x, Reaches<double>& reaches) noexcept;

// About the same direction in few digits: the largest coordinate is between 1 and 2, and all are multiples of 2^-bits.
// Zero where there is no direction.
Vec3 shortened(const Vec3& direction, int bits = 16);

}  // namespace ecods
