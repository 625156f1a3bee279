// A ball, prepared for being tested against many boxes.
#pragma once

#include "bounds/segment_bounds.hpp"
#include "ecods/ball.hpp"

namespace ecods {

// The squared distance of the center from a box is the sum of the squared gaps on the axes: min - c, c - max or none.
//
// Bound. With u' = 2^-52 (any rounding mode) a gap is off by u', relative, its square by 3.01 u', and the sum of three
// by 5.1 u'; the squared radius by u'. Together the two are off by less than 6.2 u' m, m being the larger of them, and
// 16 u' m covers the evaluation of the comparison, too. Underflow, subnormals taken for zero included, loses less than
// 2^-1020 in a gap and in a square; below 2^-500 m, where m is at least 2^-900. Overflow: m must be below 2^900; a mode
// that rounds down makes large numbers of infinities, and these are not.
class BallBounds {
  public:
    explicit BallBounds(const Ball& ball) noexcept;

    // A box that contains the ball, but for what no double reaches.
    const Aabb& box() const noexcept { return box_; }

    // Of any box.
    BoxVerdict judge(const Aabb& box) const noexcept;

    // overlap(ball, box)
    bool meets(const Aabb& box) const noexcept;

  private:
    Ball ball_;
    Aabb box_;
    double square_;  // of the radius, rounded
};

}  // namespace ecods
