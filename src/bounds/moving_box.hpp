// A MovingBox computes bounds of the times at which a moving box may meet other boxes. The bounds serve to leave out
// boxes; no answer follows from a bound alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Holds the six sides of a box that moves with constant velocity from time 0 on. A segment or ray counts as a moving
// box, too: as a moving point, whose times are the parameters of the line.
//
// For each side, the side of another box that faces it is its partner. In the direction out of the moving box, the side
// is at p + s v at time s, and its partner at e. The two boxes share a point on that axis at the times at which e <= p
// + s v holds for both pairs of sides. For one pair, the inequality holds from some time on if v > 0 (a coming side),
// up to some time if v < 0 (a going side), and at all times or at none if v = 0. The boxes meet at time s if the
// inequality holds for all six pairs at s.
//
// Bounds. `velocity` is an upper bound of the real velocity. A greater velocity makes the time of a coming side
// earlier, and that of a going side later: both errors are to the safe side. Let u' = 2^-52, which bounds the relative
// error of one operation in any rounding mode. Five operations compute a time: the difference, the step by `gap_min`,
// the inverse of the speed, its factor and the product. So a time is off by little more than 5 u', and the factors 1 -+
// 2^-48 subtract or add 16 u'.
//
// If subnormal numbers are flushed to zero, differences and coordinates are off by at most 3 * 2^-1022. `gap_min`,
// which is more than 2^60 times that, is subtracted from the gap of a coming side, and added to the gap of a going
// side. Speeds below 2^-1000 and above 2^1000 are replaced by these limits, or by infinity, whichever proves less. So
// no inverse is subnormal. A product that is subnormal or flushed to zero is off by less than 2^-1021; therefore a box
// is left out only if the lower bound of its first time exceeds the upper bound of its last time by more than
// `time_min`. Gaps that overflow are at least the largest double. NaN, from 0 times infinity, proves nothing.
//
// All steps are monotone: if box a contains box b, the time of a is at most the time of b.
// Claim: verify/proofs/lines_and_times.py
class MovingBox {
  public:
    explicit MovingBox(const Segment& segment) noexcept;
    explicit MovingBox(const Ray& ray) noexcept;
    MovingBox(const Aabb& box, const Vec3& motion) noexcept;

    // Returns a lower bound of the first time from 0 on at which the moving box and `box` share a point, up to the
    // rounding of subnormal times. Returns infinity only if they share no point at any time.
    double meets_from(const Aabb& box) const noexcept;

    // Returns an upper bound of meets_from(box) for every box that is met at a time that rounds to at most `limit`. The
    // result may be one step above a subnormal limit, because of modes that round up.
    static double latest(double limit) noexcept { return limit < subnormal_below ? next_up(limit) : limit; }

    enum class Course : std::uint8_t { coming, going, resting, without_end };
    struct Side {
        Course course = Course::without_end;
        double end = 0;        // p
        std::int64_t key = 0;  // key_of(p)
        double factor = 0;     // inverse of the speed, rounded to the safe side
    };

    // Returns first three sides whose partners are the minima of other boxes, axis by axis, and then three sides whose
    // partners are the maxima. For the last three, p and e are negated coordinates.
    const std::array<Side, 6>& sides() const noexcept { return sides_; }

    static constexpr double gap_min = 0x1p-960, time_min = 0x1p-1000, number_max = std::numeric_limits<double>::max();
    static constexpr double subnormal_below = 0x1p-1021;

  private:
    void set(std::size_t side, double p, double velocity) noexcept;

    std::array<Side, 6> sides_;
};

// Passes the time as the second argument of std::min and std::max: so a time that is NaN changes nothing.
inline double MovingBox::meets_from(const Aabb& box) const noexcept {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 6; ++i) {
        const Side& side = sides_[i];
        const auto axis = static_cast<Eigen::Index>(i % 3);
        const double e = i < 3 ? box.min[axis] : -box.max[axis];
        if (side.course == Course::without_end) continue;
        if (side.course == Course::coming) {
            from = std::max(from, (std::min(e - side.end, number_max) - gap_min) * side.factor);
            continue;
        }
        if (key_of(e) > side.key) return std::numeric_limits<double>::infinity();
        if (side.course == Course::going) to = std::min(to, ((side.end - e) + gap_min) * side.factor);
    }
    return from - time_min > to ? std::numeric_limits<double>::infinity() : std::min(from, number_max);
}

}  // namespace ecods
