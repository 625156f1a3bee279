// FarGap computes lower bounds of distances between nodes of two posed trees whose distance is much greater than their
// size.
//
// For such trees the squared distances of all pairs of nodes round to about the same float: their relative differences
// are less than v. But their projections on the vector n between the trees' centers differ as much as their own
// coordinates do, and
//     |q - p| >= n . (q - p) / |n|
// is nearly an equality for two points p and q: the difference is about the square of the part of q - p perpendicular
// to n, divided by twice the distance. With the maps A and B of separating_axes.hpp, m_a = A^T n, m_b = B^T n and g = n
// . (o_b - o_a),
//     n . (q - p) = (m_b . y_b - m_a . y_a) + g.
// The sum in parentheses has the size of the trees, and is bounded in floats; g, and the distances with which it is
// compared, are doubles. So the projections on n prove that the distance of two boxes exceeds L if
//     reach + (least m_b . y_b - greatest m_a . y_a) > reach + (|n| L - g).
// The left side is called the rank of the pair. The rank is about zero for the nearest nodes. The walk visits pairs by
// increasing rank.
//
// Bound. The letters are those of separating_axes.hpp, except that S = |m_a| 1 + |m_b| 1. Floats: converting m,
// products and sums cost 4.01 v each for the middle and the reach of a box, and its end 2 v: 10.1 v S. Corners of
// triangles cost 1.01 v S, and converting, products and sums 4.01 v S, which is less. The difference is below 2 S, and
// adding reach = S makes 3 S: 5 v S for both. The margin is 24 v S. Doubles: n is a row of N, so the margin of
// DoubleAxes covers m_a, m_b and g. |n| is off by 2.5 u', and two products by u' each; 16 u' are added. The sums that
// are compared have four roundings of u' times the sum of their terms' magnitudes at most, and 8 u' of that sum are
// added. Underflow: see separating_axes.hpp; for n in units it is 2^-600 of |n|.
// Claim: verify/proofs/float_axes.py
#pragma once

#include <cstdint>

#include "bvh/axes/distance_axes.hpp"

namespace ecods {

class FarGap {
  public:
    // Binds two posed trees. `axes` must be bound to the same trees and `d`.
    void bind(const DistanceAxes& axes, const PosedTree& a, const PosedTree& b, const Vec3& d);

    // Returns true if the trees are so far apart that ranks prune better than squared distances do. If it is false, no
    // other member may be used.
    bool is_far() const noexcept { return is_far_; }

    // Returns an upper bound of the ranks of all pairs whose distance is at most `distance`, which may be infinity. The
    // result is finite and not negative.
    float rank_above(double distance) const noexcept;

    // a and b are the vectors m_a and m_b of the derivation above, for the kernels: the axis n in the coordinates of
    // the first and of the second tree.
    std::array<float, 3> a{}, b{};
    float reach = 0;

  private:
    bool is_far_ = false;
    double unit_ = 1;
    double length_ = 1;  // |n|
    double gap_ = 0;     // g
    double margin_ = 0;
};

// Returns a mask of the pairs of lanes whose rank is not proven to exceed `limit`; bit 8 j + i is for lane i of x and
// lane j of y. Sets `ranks` to lower bounds of the ranks of these pairs.
template <class X, class Y>
std::uint64_t far_mask(const FarGap& gap, float limit, const X& x, const Y& y, LaneBounds& ranks) noexcept;

}  // namespace ecods
