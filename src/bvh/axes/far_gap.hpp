// Bounds the distances between nodes of two posed trees that are very far apart compared with their size.
//
// For such trees the squared distances of all pairs of nodes round to about the same float: they differ by less than v,
// relatively. But along the vector n between the trees' centers, nodes differ as much as they do in their own
// coordinates, and
//     |q - p| >= n . (q - p) / |n|
// is nearly an equality for two points p and q: the difference is about the squared part of q - p across n, divided by
// twice the distance. With the maps A and B of separating_axes.hpp, m_a = A^T n, m_b = B^T n and g = n . (o_b - o_a),
//     n . (q - p) = (m_b . y_b - m_a . y_a) + g.
// The sum in parentheses has the size of the trees, and is bounded in floats; g and the distances it is compared with
// are doubles. So the projections on n prove a pair of boxes farther apart than L exactly if
//     reach + (least m_b . y_b - greatest m_a . y_a) > reach + (|n| L - g).
// The left side is called the rank of the pair. It is about zero for the nearest nodes, and the walk orders pairs by
// it.
//
// Bound. The letters are those of separating_axes.hpp, except that S = |m_a| 1 + |m_b| 1. Floats: converting m,
// products and sums cost 4.01 v each for the middle and the reach of a box, its end 2 v: 10.1 v S; corners of triangles
// cost 1.01 v S, converting, products and sums 4.01 v S, which is less. The difference is below 2 S, adding reach = S
// makes 3 S: 5 v S for both. The margin is 24 v S. Doubles: n is a row of N, so the margin of DoubleAxes covers m_a,
// m_b and g. |n| has 2.5 u', two products u' each, and 16 u' are added. The sums that are compared have four roundings
// of u' of at most the sum of their terms' magnitudes, and 8 u' of that sum are added. Underflow: see
// separating_axes.hpp; for n in units it is 2^-600 of |n|.
// Claim: verify/proofs/float_axes.py
#pragma once

#include <cstdint>

#include "bvh/axes/distance_axes.hpp"

namespace ecods {

class FarGap {
  public:
    // Binds to the two trees and the `d` that `axes` is bound to.
    void bind(const DistanceAxes& axes, const PosedTree& a, const PosedTree& b, const Vec3& d);

    // True if the trees are so far apart that ranks prune better than squared distances do. Otherwise no other member
    // may be used.
    bool is_far() const noexcept { return is_far_; }

    // Returns a finite, nonnegative upper bound of the ranks of all pairs within `distance`, which may be infinite.
    float rank_above(double distance) const noexcept;

    // The vectors m_a and m_b that the kernels use: n in the coordinates of either tree.
    std::array<float, 3> a{}, b{};
    float reach = 0;

  private:
    bool is_far_ = false;
    double unit_ = 1;
    double length_ = 1;  // |n|
    double gap_ = 0;     // g
    double margin_ = 0;
};

// Returns the mask that near_mask returns, with ranks in place of squared distances.
template <class X, class Y>
std::uint64_t far_mask(const FarGap& gap, float limit, const X& x, const Y& y, LaneBounds& ranks) noexcept;

}  // namespace ecods
