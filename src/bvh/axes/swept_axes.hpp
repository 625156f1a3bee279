// Finds the times at which nodes of two posed trees may share a point while the first tree is translated.
//
// On any axis n the first tree's box moves at the constant speed n.m: it shares points of the axis with another box in
// an interval of time, and the boxes can share a point only in the intersection of these intervals. Axes and bounds are
// those of separating_axes.hpp, in two sets: the face normals of either tree's boxes.
//
// Time. Floats know a place on an axis to one part in 2^23 of all that is added up to it, the motion included. So the
// kernels work in a window of time only, outside of which doubles prove that the roots share no point. The motion
// within the window is about as long as the trees are wide, however long the whole motion is. Times in the window are
// from 0 to 1: the time in the world is start + length times that.
//
// Bound. A place on an axis at a time is P y + q - s v, v = N m', for the second tree's points less the first's, m' the
// motion in the window and q from the trees' places at its start. Adding |v| to the sum s, and |m'| and the parts of q
// to w, the margins of separating_axes.hpp cover the error of v: m' has u', products and sums 3.01 u', converting it to
// floats v, all with a time of at most one. So v can be taken for exact. Times are then quotients of a difference of
// ends and |v|: three roundings, for which 2^-20 of the times is subtracted or added. Products that underflow are off
// by less than 2^-126; 2^-100 is added to the end of an interval, and to limits. For slabs, whose bound is 24 v s, of
// which 23 are used, n.v adds 4.01 v |v|, but |v| is not a part of the error of places: it uses less than 24 v |v|. A
// speed of zero, or one that underflows to it, has no quotient: beginnings then are at most 2^100 times the gap, and
// ends are infinite, or NaN if the gap is zero, which limits nothing.
// Claim: verify/proofs/small_bounds.py
#pragma once

#include <array>
#include <cstdint>

#include "bvh/axes/distance_axes.hpp"
#include "bvh/axes/separating_axes.hpp"

namespace ecods {

struct SweptSet {
    AxisSet axes;
    std::array<float, 4> velocity;  // motion of the first tree on the axes, in the window
};

class SweptAxes {
  public:
    // Returns false if the trees certainly share no point from time 0 to `latest`. `d` is fl(t_b - t_a).
    bool bind(const PosedTree& a, const PosedTree& b, const Vec3& d, const Vec3& motion, double latest);

    const std::array<SweptSet, 2>& sets() const noexcept { return sets_; }

    // Returns an upper bound, from 0 to slightly above 1, of the times in the window that round to `time` or less in
    // the world.
    float window_above(double time) const noexcept;

  private:
    std::array<SweptSet, 2> sets_;
    double start_ = 0, length_ = 1;
};

// Returns a mask of the pairs of lanes that may share a point until `limit`, in the layout of near_mask, and sets lower
// bounds of the times in the window at which they do. `limit` is finite.
template <class X, class Y>
std::uint64_t swept_mask(const std::array<SweptSet, 2>& sets, float limit, const X& x, const Y& y,
                         LaneBounds& times) noexcept;

}  // namespace ecods
