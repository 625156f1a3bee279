// SeparatingAxes proves boxes of two posed trees disjoint, for any two affine poses.
//
// Two boxes are disjoint if their exact projections on some vector n are. Any n is sound: it need not be accurate, only
// the projections need an error bound. Axes come in sets of three: the face normals of one tree's boxes (under a
// sheared pose these are not the directions of the edges), or the axes of the world if a pose is too flat for normals
// to be accurate. A zero axis never separates.
//
// With the trees' frames v = center + map y, and world coordinates relative to the first body's translation, the boxes
// are
//     A y + o_a,  |y - y_a| <= h_a,   A = R_a map_a,  o_a = R_a center_a,
//     B y + o_b,  |y - y_b| <= h_b,   B = R_b map_b,  o_b = R_b center_b + d,    d = t_b - t_a.
// With the axes as the rows of N, P_a = N A, P_b = N B and q = N (o_b - o_a), row k separates the boxes if and only if
//     |P_a y_a - P_b y_b - q|  >  |P_a| h_a + |P_b| h_b      in row k.
//
// Bound. Let u' = 2^-52 (doubles, any rounding mode), w_a = |N| |R_a| |map_a| 1, w_b likewise, and w_d = |N| (|R_a|
// |center_a| + |R_b| |center_b| + |d|). Summed over a row, products of two and three matrices make P_a off by 6.1 u'
// w_a and P_b by 6.1 u' w_b. q is off by 8.2 u' w_d, including the rounding of d as a difference. All |y| and h are at
// most 1 + 2^-22, so the errors are
//     |P_a y_a|, |P_a| h_a: 6.2 u' w_a each; likewise b; q: 8.2 u' w_d.   Together 12.4 u' (w_a + w_b) + 8.2 u' w_d,
// and with the roundings of the sums w themselves (relative 10 u') below 13 u' w, w = w_a + w_b + w_d.
//
// In floats let v = 2^-23, S_a = |P_a| 1 and S_b = |P_b| 1, and s = S_a + S_b + |q|, in one row.
//   Corners of triangles, P y + q: converting P and q costs v s; the error of y (corner_error) 1.01 v S; products
//   and sums 3.01 v S; adding q v s. With the errors of P and q that is below 7 v s + 13 u' w; a bound of 8 v s + 16 u'
//   w has a margin for its own evaluation. Boxes are exact in y: converting P and products and sums cost 4.01 v S for
//   the middle and as much for the reach; q, adding it, adding the margin, and the two ends cost v s each: below 14 v s
//   for both boxes. Ends of triangles are no worse. A margin of 16 v s + 16 u' w is enough for all. If a tree's boxes
//   are on its own normals, P is the identity up to rounding, and is taken for it. With e the sum of |P - I| over the
//   row, corners are then off by e more, and middle and reach of boxes by 2 e.
//
// Doubles (for the roots) have no conversions: below 15 u' s + 13 u' w. For the products of edges, n' = column of P_a x
// column of P_b is computed in the coordinates N x. Its projections have the row bounds, weighted: sum |n'_k| (...)_k,
// and P^T n' as computed adds 6.1 u' sum |n'_k| s_k. Hence the margin 32 u' (s + w) for a row of either kind.
//
// Underflow: a hundred operations lose 2^-1022 each (also where subnormals are taken for zero) times a factor of at
// most 2^900, which is checked (otherwise the margin is infinite): below 2^-100. Floats lose 2^-126 each. Overflow: s
// and w are required to be below 2^100. Otherwise, and for NaN, the margin is infinite and the row never separates. A
// mode that rounds down turns infinities into large numbers, which a short axis would hide. Therefore the sum of
// magnitudes before the projection by N, an upper bound of every world coordinate, is required to be below 2^1000.
// Claim: verify/proofs/posed_axes.py
// Claim: verify/proofs/float_axes.py
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// Refers to a tree and the linear part of its pose.
struct PosedTree {
    const MeshBvh& tree;
    const Mat3& R;
};

// Holds the map y -> p y + shift from a tree's coordinates to three axes.
struct Projection {
    std::array<std::array<float, 4>, 3> p;     // p[c] is column c: an entry per axis, then 0; unset if is_unit
    std::array<std::array<float, 4>, 3> size;  // |p|
    std::array<std::array<float, 4>, 3> row;   // p by rows, and the shift as fourth column
    std::array<float, 4> shift;                // added to p y
    std::array<float, 4> margin;               // added to the reach of boxes
    bool is_unit;                              // p is taken for the identity; p, size, row are unset but the shift
};

// Holds both trees on three axes.
struct AxisSet {
    Projection a, b;                   // shift and margin are zero for a
    std::array<float, 4> point_error;  // error bound of a corner of either tree
    int flat_axis = -1;                // axis along which both trees are nearly flat; -1 if there is none
    bool is_bijective = false;         // true if the map to the axes' coordinates is certainly a bijection

    // Makes all margins infinite, so that the set proves no boxes apart.
    void set_unbounded() noexcept {
        b.margin.fill(std::numeric_limits<float>::infinity());
        point_error.fill(std::numeric_limits<float>::infinity());
    }
};

inline constexpr int root_axis_count = 15;

class SeparatingAxes {
  public:
    // Binds two posed trees; `d` is fl(t_b - t_a). Returns the number of an axis that certainly separates the roots: 0
    // to 2 for the normals of a's faces, 3 to 5 for b's, 6 to 14 for the cross products of their edges. Returns -1 if
    // no such axis is found; only then are the sets ready for overlap_mask(). The group of axes that contains `first`
    // is tried first, unless it is -1.
    int bind(const PosedTree& a, const PosedTree& b, const Vec3& d, int first = -1);

    const std::array<AxisSet, 2>& sets() const noexcept { return sets_; }

  private:
    std::array<AxisSet, 2> sets_;
};

// Returns a mask of the pairs of lanes that may overlap; bit 8 j + i is for lane i of x, in the first tree, and lane j
// of y, in the second. A bit is clear if the pair is proven disjoint, by one of the six face normals or by a slab, or
// for the triangles of two leaves by triangle_pairs(). Bits of lanes that repeat another lane are clear.
template <class X, class Y>
std::uint64_t overlap_mask(const std::array<AxisSet, 2>& sets, const X& x, const Y& y) noexcept;

// Holds two sets of pairs of triangles of two leaves; bit 8 j + i is for triangle i of x and triangle j of y.
struct TrianglePairs {
    std::uint64_t near = 0;      // not proven disjoint by an axis, by a triangle's plane, or by an edge of each
    std::uint64_t crossing = 0;  // pairs in `near` that are proven to cross
};
TrianglePairs triangle_pairs(const std::array<AxisSet, 2>& sets, const TreeLeaf& x, const TreeLeaf& y) noexcept;

}  // namespace ecods
