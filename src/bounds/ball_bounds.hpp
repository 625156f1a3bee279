// BallBounds is a ball, prepared for tests against many boxes.
#pragma once

#include "bounds/segment_bounds.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Compares the squared distance of the ball's center c and a box with the squared radius. The squared distance is the
// sum of the squared gaps on the axes; a gap is min - c, c - max or 0.
//
// Bound. With u' = 2^-52 (any rounding mode) a gap has a relative error of u', its square of 3.01 u', and the sum of
// three squares of 5.1 u'; the squared radius has u'. Let m be the larger of sum and squared radius. Their difference
// is off by less than 6.2 u' m; the bound 16 u' m also covers the rounding of the comparison itself. Underflow, also of
// subnormal numbers that are taken for zero, loses less than 2^-1020 in a gap and in a square, which is below 2^-500 m
// if m is at least 2^-900. m must also be below 2^900, because a mode that rounds down turns infinities into large
// numbers. For other m nothing is proved.
// Claim: verify/proofs/small_bounds.py
class BallBounds {
  public:
    explicit BallBounds(const Ball& ball) noexcept;

    // Returns a box that contains all points of the ball whose coordinates are in the range of doubles.
    const Aabb& box() const noexcept { return box_; }

    // Tests the ball against any box in floating-point arithmetic; returns `unknown` if the error bound does not allow
    // a decision.
    BoxVerdict judge(const Aabb& box) const noexcept;

    // Returns true if the ball and the box share a point. The result is exact, like that of overlap(ball, box).
    bool meets(const Aabb& box) const noexcept;

  private:
    Ball ball_;
    Aabb box_;
    double square_;  // squared radius, rounded
};

}  // namespace ecods
