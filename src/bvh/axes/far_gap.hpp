// Bounds of distances between the nodes of two posed trees that are very far apart compared with their size.
//
// There, squared distances in floats are all the same: what nodes differ by is below v of them. But along the vector n
// between the trees' centers nodes differ as much as they do in their own coordinates, and
//     |q - p| >= n . (q - p) / |n|
// is the distance of two points but for the square of what is across n, divided by twice the distance. With the maps
// of separating_axes.hpp, and m_a = A^T n, m_b = B^T n, g = n . (o_b - o_a),
//     n . (q - p) = (m_b . y_b - m_a . y_a) + g.
// The sum in parentheses has the size of the trees, and is bounded in floats; g and the distances it is compared with
// are doubles. So a pair is farther than L exactly where, of its boxes,
//     reach + (least m_b . y_b - greatest m_a . y_a) > reach + (|n| L - g),
// the left side being called its rank. It is about zero for the nearest nodes, and is what the walk orders them by.
//
// Bound, with the letters of separating_axes.hpp, but S = |m_a| 1 + |m_b| 1. Floats: converting m, products and sums
// 4.01 v each for the middle and the reach of a box, its end 2 v: 10.1 v S; corners of triangles 1.01 v S, converting,
// products and sums 4.01 v S, which is less. The difference is below 2 S, adding reach = S makes 3 S: 5 v S for both.
// 24 v S has margin. Doubles: m_a, m_b and g are a row of N as there: DoubleAxes has a margin for them. |n| has 2.5 u',
// two products u' each, and 16 u' are added. The sums of what is compared: four roundings of u' of at most the sum of
// their magnitudes, of which 8 u' are added. Underflow: see there; of n in units it is 2^-600 of |n|.
#pragma once

#include <cstdint>

#include "bvh/axes/distance_axes.hpp"

namespace ecods {

class FarGap {
  public:
    // `axes` must be bound to the same trees and `d`.
    void bind(const DistanceAxes& axes, const PosedTree& a, const PosedTree& b, const Vec3& d);

    // Whether the trees are so far apart that ranks say more than squares do. Otherwise nothing else may be asked.
    bool is_far() const noexcept { return is_far_; }

    // No pair within `distance` has a rank above it. Not negative, and finite, for infinity, too.
    float rank_above(double distance) const noexcept;

    // What the kernels use: n on the coordinates of either tree.
    std::array<float, 3> a{}, b{};
    float reach = 0;

  private:
    bool is_far_ = false;
    double unit_ = 1;
    double length_ = 1;  // |n|
    double gap_ = 0;     // g
    double margin_ = 0;
};

// As near_mask, with ranks in place of squares.
template <class X, class Y>
std::uint64_t far_mask(const FarGap& gap, float limit, const X& x, const Y& y, LaneBounds& ranks) noexcept;

}  // namespace ecods
