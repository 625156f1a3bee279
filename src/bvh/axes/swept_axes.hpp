// SweptAxes bounds the times at which nodes of two posed trees may share a point while the first tree is translated.
//
// On any axis n the first tree's box moves at the constant speed n.m. The projections of this box and of another box
// share points in an interval of time, and the boxes can share a point only in the intersection of these intervals.
// Axes and bounds are as in separating_axes.hpp, in two sets: the face normals of a's boxes and of b's boxes.
//
// Time. In floats, a position on an axis has a relative error of 2^-23 of the sum of all its terms, including the
// motion. So the kernels compute only in a window of time, outside of which doubles prove that the roots share no
// point. The motion within the window is about as long as the trees are wide, however long the whole motion is. Times
// in the window are from 0 to 1: the time in the world is start + length times the time in the window.
//
// Bound. Let P y + q - s v be the difference of a point of the second tree and one of the first on an axis at time s,
// where v = N m', m' is the motion in the window, and q is from the trees' positions at its start. If |v| is added to
// the sum s of separating_axes.hpp, and |m'| and the parts of q to w, the margins there cover the error of v: m' has
// u', products and sums 3.01 u', converting it to floats v, all with a time of at most one. So v can be taken for
// exact. Times are then quotients of a difference of ends and |v|: three roundings, for which 2^-20 of the times is
// subtracted or added. Products that underflow are off by less than 2^-126; 2^-100 is added to the end of an interval,
// and to limits. For slabs, whose bound is 24 v s, of which 23 are used, n.v adds 4.01 v |v|, but |v| is not a part of
// the error of positions: it uses less than 24 v |v|. If a speed is zero, or underflows to zero, there is no quotient:
// then the beginning of an interval is at most 2^100 times the gap, and the end is infinite, or NaN if the gap is zero,
// which limits nothing.
// Claim: verify/proofs/small_bounds.py
#pragma once

#include <array>
#include <cstdint>

#include "bvh/axes/distance_axes.hpp"
#include "bvh/axes/separating_axes.hpp"

namespace ecods {

struct SweptSet {
    AxisSet axes;
    std::array<float, 4> velocity;  // motion of the first tree on the axes, during the window
};

class SweptAxes {
  public:
    // Binds two posed trees; `d` is fl(t_b - t_a). Returns false if the trees certainly share no point from time 0 to
    // `latest`.
    bool bind(const PosedTree& a, const PosedTree& b, const Vec3& d, const Vec3& motion, double latest);

    const std::array<SweptSet, 2>& sets() const noexcept { return sets_; }

    // Returns an upper bound, from 0 to slightly above 1, of all times in the window whose times in the world round to
    // at most `time`.
    float window_above(double time) const noexcept;

  private:
    std::array<SweptSet, 2> sets_;
    double start_ = 0, length_ = 1;
};

// Returns a mask of the pairs of lanes that may share a point up to the time `limit` in the window, which must be
// finite; bit 8 j + i is for lane i of x and lane j of y. Sets `times` to lower bounds of the times in the window at
// which these pairs share points.
template <class X, class Y>
std::uint64_t swept_mask(const std::array<SweptSet, 2>& sets, float limit, const X& x, const Y& y,
                         LaneBounds& times) noexcept;

}  // namespace ecods
