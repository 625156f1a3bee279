// BallBounds is a ball that is prepared for tests against many boxes.
#pragma once

#include "bounds/segment_bounds.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Compares the squared distance of the center from a box with the squared radius. The squared distance is the sum of
// the squared gaps on the axes: min - c, c - max or none.
//
// Bound. With u' = 2^-52 (any rounding mode) a gap has a relative error of u', its square of 3.01 u', and the sum of
// three of 5.1 u'; the squared radius has u'. Together the two are off by less than 6.2 u' m, where m is the larger of
// them, and 16 u' m covers the evaluation of the comparison, too. Underflow, subnormals taken for zero included, loses
// less than 2^-1020 in a gap and in a square; this is below 2^-500 m if m is at least 2^-900. Overflow: m must be below
// 2^900, since a mode that rounds down turns infinities into large numbers.
// Claim: verify/proofs/small_bounds.py
class BallBounds {
  public:
    explicit BallBounds(const Ball& ball) noexcept;

    // Returns a box that contains the ball, except for points beyond all doubles.
    const Aabb& box() const noexcept { return box_; }

    // Decides any box by doubles and the bound.
    BoxVerdict judge(const Aabb& box) const noexcept;

    // Returns overlap(ball, box).
    bool meets(const Aabb& box) const noexcept;

  private:
    Ball ball_;
    Aabb box_;
    double square_;  // squared radius, rounded
};

}  // namespace ecods
