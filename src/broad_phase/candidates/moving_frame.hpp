// Defines the frame in which fat boxes are kept: it moves along with boxes that all move together.
#pragma once

#include <cmath>
#include <limits>

#include "broad_phase/boxes/packed_box.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Holds a translation, and the step by which it changes in each update in which most boxes move. Boxes are compared
// with fat boxes only in this frame, in which the boxes of a flying swarm are at rest. A frame at the origin leaves
// boxes as they are. Any other frame makes boxes a little larger, so that a box that is inside its fat box in the frame
// is also inside it in space.
class MovingFrame {
  public:
    bool is_moving() const noexcept { return !step_.isZero(0); }
    bool is_at_origin() const noexcept { return is_at_origin_; }

    // Returns the vector by which the frame moved in this update.
    Vec3 went() const noexcept { return at_ - before_; }

    // Lets the frame move by `step` in each further update. This update found boxes to have moved by `step` on the
    // whole, so went() is set as if the frame had moved with them.
    void start(const Vec3& step) noexcept {
        step_ = step.allFinite() && (at_ - step).allFinite() ? step : Vec3::Zero();
        before_ = at_ - step_;
    }
    void advance() noexcept {
        before_ = at_;
        if (!(at_ + step_).allFinite()) step_ = Vec3::Zero();
        at_ += step_;
        is_at_origin_ = at_.isZero(0);
    }
    void stay() noexcept { before_ = at_; }

    // Returns a box in this frame that contains `box`. of() is for a box as it is now, of_before() for a box as it was
    // before the update.
    Aabb of(const Aabb& box) const noexcept { return is_at_origin() ? box : minus(box, at_); }
    Aabb of_before(const Aabb& box) const noexcept { return before_.isZero(0) ? box : minus(box, before_); }

  private:
    // Returns box - shift, with each end moved outwards by more than rounding may have moved it inwards, in any
    // rounding mode. With u = 2^-53, the difference d is off by at most 2u |d|, and so is the subtraction or addition
    // that then moves the end; 8u |d| is more than both errors. If subnormals are flushed to zero, both operands and
    // the result are off by at most 2^-1022 each, in total less than 2^-1018. A lower end of +infinity, or an upper end
    // of -infinity, is replaced by the largest double of that sign, which is still a bound of the difference.
    static Aabb minus(const Aabb& box, const Vec3& shift) noexcept {
        constexpr double largest = std::numeric_limits<double>::max(), eight_u = 0x1p-50, least = 0x1p-1018;
        Aabb result;
        for (Eigen::Index k = 0; k < 3; ++k) {
            const double low = box.min[k] - shift[k], high = box.max[k] - shift[k];
            const double low_end = low < largest ? low : largest, high_end = high > -largest ? high : -largest;
            result.min[k] = low_end - (eight_u * std::abs(low_end) + least);
            result.max[k] = high_end + (eight_u * std::abs(high_end) + least);
        }
        return result;
    }

    Vec3 at_ = Vec3::Zero(), before_ = Vec3::Zero(), step_ = Vec3::Zero();
    bool is_at_origin_ = true;
};

}  // namespace ecods
