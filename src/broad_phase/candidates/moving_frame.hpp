// The frame in which fat boxes are kept: it goes along with boxes that all move together.
#pragma once

#include <cmath>
#include <limits>

#include "broad_phase/boxes/packed_box.hpp"
#include "ecods/aabb.hpp"

namespace ecods {

// A translation, and the step by which it changes in each update in which boxes move. Boxes are compared with fat boxes
// in this frame alone, where those of a swarm that flies are at rest. The frame of the origin holds the very boxes; any
// other holds boxes that are a little too large, so that a box in its fat box there is in it in space.
class MovingFrame {
  public:
    bool is_moving() const noexcept { return !step_.isZero(0); }
    bool is_at_origin() const noexcept { return is_at_origin_; }

    // How far it has gone in this update.
    Vec3 went() const noexcept { return at_ - before_; }

    // For an update that found boxes to have moved so far on the whole: as if the frame had gone with them.
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

    // What contains a box as it is now, and as it was before the update, in this frame.
    Aabb of(const Aabb& box) const noexcept { return is_at_origin() ? box : minus(box, at_); }
    Aabb of_before(const Aabb& box) const noexcept { return before_.isZero(0) ? box : minus(box, before_); }

  private:
    // Each end is moved out by more than what rounding may have moved it in, in any rounding mode: with u = 2^-53 the
    // difference d is off by at most 2u |d|, and so is what is subtracted from it then; 8u |d| is more than both. Where
    // subnormals are taken for zero, both operands and the result are off by 2^-1022 each at most, which is less than
    // 2^-1018. A difference beyond the largest double is at least that one.
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
