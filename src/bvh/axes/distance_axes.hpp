// DistanceAxes computes lower bounds of distances between the nodes of two posed trees, for any two affine poses.
//
// Distances are squared and in units of a power of two, about the size of the larger tree in the world: so they are in
// the range of floats for any poses. As in separating_axes.hpp, both trees are projected to two sets of axes N, one for
// the directions of each tree's boxes. Here the rows of N must be nearly orthogonal and of nearly one length, because
//     |x| >= |N x| / sqrt(largest eigenvalue of N N^T),
// so the gaps of boxes on the three axes give a lower bound of their distance. If a pose is not a similarity (it
// stretches, shears, or flattens), the axes of the world are taken, and both trees' boxes are projected.
//
// Bound. Ends of boxes have the margins of separating_axes.hpp. Errors from here on are relative, with v = 2^-23. A gap
// is a difference of ends: it is off by v, and its square by 2 v. Squaring, two sums and the factor `square` add v
// each: together below 7 v. For slabs the normal's length is at most 1 + 2^-22, its square 1 + 2^-21. `square` is
// smaller than the real factor by 2^-18, which covers these errors. With u' = 2^-52, K = N N^T / factor and tau the
// largest row sum of |K - I|, the largest eigenvalue of N N^T is at most factor (1 + tau) (Gershgorin). K as computed
// is off by 6 u', and the axes as used by 2^-170: 2^-40 is added to tau.
//
// Underflow: a mode that rounds up makes squares larger by 2^-149 each, and products by as much. With `square` below
// 2^5 the sum of these is below 2^-140, and limits, with which squares are compared, are raised by 2^-120. Overflow:
// the sums s are required to be below 2^55. Otherwise the margin is infinite, and gaps are 0, as they are for NaN.
// Claim: verify/proofs/small_bounds.py
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bvh/axes/separating_axes.hpp"

namespace ecods {

struct DistanceSet {
    AxisSet axes;
    // `square` and `square_up` are factors of the squared length of a vector on the axes. The product with `square` is
    // a lower bound of the squared length of the vector in units; the product with `square_up` is an upper bound.
    float square;
    float square_up;
};

// Returns an upper bound of the squared `distance`, converted to units. `distance` must be >= 0, and may be infinity.
float square_above(double distance, double unit) noexcept;
// Returns an upper bound of the distance of two points, one of each of two triangles. `square` is their squared
// distance on the set's axes as computed (bvh/masks/triangle_bounds.hpp).
double distance_above(const DistanceSet& set, float square, double unit) noexcept;

// far_min is the least distance of far bodies, in units (about the size of the larger tree). By measured counts, at
// greater distances ranks (FarGap) leave fewer pairs than squared distances do. The value affects only the work, not
// the results.
inline constexpr double far_min = 0x1p9;
// Returns true unless the distance of the trees' origins on the set's axes is more than far_min.
bool is_near(const DistanceSet& set) noexcept;

class DistanceAxes {
  public:
    // Binds two posed trees; `d` is fl(t_b - t_a).
    void bind(const PosedTree& a, const PosedTree& b, const Vec3& d);

    const std::array<DistanceSet, 2>& sets() const noexcept { return sets_; }

    // Returns the unit, a power of two: a distance in units times unit() is a distance in the world.
    double unit() const noexcept { return unit_; }

    // Convert between distances and squares, on the first set's axes.
    float square_above(double distance) const noexcept { return ecods::square_above(distance, unit_); }
    double distance_above(float square) const noexcept { return ecods::distance_above(sets_[0], square, unit_); }
    // Returns a lower bound of the distance in the world whose square in units is `square`.
    double distance_below(float square) const noexcept;

  private:
    std::array<DistanceSet, 2> sets_;
    double unit_ = 1;
};

// PointAxes projects a point and a posed tree to axes that are good for the tree's boxes: the second set of
// DistanceAxes, for a first body that is one point, at the origin of the axes.
class PointAxes {
  public:
    // Binds a posed tree; `d` is fl(t - point), where t is the translation of the tree's pose.
    void bind(const PosedTree& tree, const Vec3& d);

    // Returns true if squared distances distinguish nodes: the tree is bounded, and the point is not so far away that
    // floats only order nodes by their positions along the gap (FarGap).
    bool are_useful() const noexcept { return are_useful_; }
    const DistanceSet& set() const noexcept { return set_; }

    // Returns an upper bound of the squared distance in units, given `square`, the computed squared distance of a point
    // of a triangle on the axes. A triangle whose lower bound exceeds the result is farther away than that point.
    float limit_of(float square) const noexcept { return square_above(distance_above(set_, square, unit_)); }
    float square_above(double distance) const noexcept { return ecods::square_above(distance, unit_); }

  private:
    DistanceSet set_;
    double unit_ = 1;
    bool are_useful_ = false;
};

// A Direction is a vector on the axes of the first set. A Direction is zero, or its length is one or slightly less.
using Direction = std::array<float, 3>;

// Returns a mask of the pairs of lanes whose squared distance is not proven to exceed `limit`; bit 8 j + i is for lane
// i of x and lane j of y. Sets `squares` to lower bounds of the squared distances of these pairs. `limit` may be
// infinity. The bounds hold for any `n`. The bounds are best if `n` is about the direction from the first body's
// closest point to the second's.
template <class X, class Y>
std::uint64_t near_mask(const std::array<DistanceSet, 2>& sets, const Direction& n, float limit, const X& x, const Y& y,
                        LaneBounds& squares) noexcept;

// Names a pair of lanes, one of each tree.
struct LanePair {
    std::size_t i;  // lane of the first tree
    std::size_t j;
};
template <class X, class Y>
LanePair nearest_lanes(const DistanceSet& set, const X& x, const Y& y) noexcept;

}  // namespace ecods
