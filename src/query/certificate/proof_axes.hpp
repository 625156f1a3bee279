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

#include <array>
#include <cstddef>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/pose.hpp"
#include "simd/inline.hpp"

namespace ecods {

// What all axes need of a posed tree.
struct BodyFrame {
    // Points are counted from `base`; d is fl(t - base).
    BodyFrame(const MeshBvh& tree, const Mat3& R, const Vec3& d);

    Mat3 edges;        // R map
    Vec3 origin;       // R center + d
    Vec3 size;         // |R| |map| 1
    Vec3 origin_size;  // |R| |center| + |d|
    bool is_bounded;
};

struct BodyAxis {
    std::array<double, 3> p{};
    double q = 0;
    double error = 0;
    double corner_reach = 0;  // what a corner of a leaf may be off
    bool is_bounded = false;  // otherwise nothing is known
};

BodyAxis put_on_axis(const BodyFrame& body, const Vec3& n);

// From where to where parts reach, by lane; `error` not included. Lanes from the number of parts on repeat the last
// one.
struct Reaches {
    alignas(32) std::array<double, tree_width> low;
    alignas(32) std::array<double, tree_width> high;
};

// Gives each lane the reach of all parts together: of Reaches, or of their like in floats.
template <class Ends>
ECODS_ALWAYS_INLINE void join_lanes(Ends& ends) noexcept {
    auto low = ends.low[0], high = ends.high[0];
    for (std::size_t lane = 1; lane < tree_width; ++lane) {
        low = ends.low[lane] < low ? ends.low[lane] : low;
        high = ends.high[lane] > high ? ends.high[lane] : high;
    }
    ends.low.fill(low);
    ends.high.fill(high);
}

void find_reaches(const BodyAxis& axis, const BvhNode& node, Reaches& reaches) noexcept;
void find_reaches(const BodyAxis& axis, const TreeLeaf& leaf, Reaches& reaches) noexcept;

// Bit 8 i + j: parts i of x and j of y are apart by more than the margin, on either side. Of all lanes i, and of those
// j that `columns` has. A leaf beside a node is one part, 0, of all of its triangles.
std::uint64_t apart_mask(const BodyAxis& a, const BodyAxis& b, double margin, const BvhNode& x, const BvhNode& y,
                         std::uint32_t columns) noexcept;
std::uint64_t apart_mask(const BodyAxis& a, const BodyAxis& b, double margin, const BvhNode& x, const TreeLeaf& y,
                         std::uint32_t columns) noexcept;
std::uint64_t apart_mask(const BodyAxis& a, const BodyAxis& b, double margin, const TreeLeaf& x, const BvhNode& y,
                         std::uint32_t columns) noexcept;
std::uint64_t apart_mask(const BodyAxis& a, const BodyAxis& b, double margin, const TreeLeaf& x, const TreeLeaf& y,
                         std::uint32_t columns) noexcept;

// About the same direction in few digits: the largest coordinate is between 1 and 2, and all are multiples of 2^-bits.
// Zero where there is no direction.
Vec3 shortened(const Vec3& direction, int bits = 16);

// The normals of a tree's boxes in the world, or the axes of the world where the pose is too flat for these. Columns.
Mat3 box_normals(const LocalFrame& frame, const Mat3& R);

}  // namespace ecods
