// From when on a box that moves may meet boxes: bounds that are used to leave boxes out, and decide nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "ecods/aabb.hpp"
#include "ecods/segment.hpp"

namespace ecods {

// A box whose sides move, each at a constant speed, from time 0 on: a box that is translated, a segment or a ray (a
// point that moves; times are parameters).
//
// A side meets the side of a box that faces it. Seen in the direction out of the moving box, it is at p + s v at time
// s, and the other one at e; the two boxes share a point on that axis at those times at which e <= p + s v holds for
// both pairs of sides. Where v > 0 that is so from a time on, where v < 0 up to a time, and where v = 0 at all times or
// at none. The boxes meet where some time is right for all six.
//
// Bounds. `velocity` is at least the real one, so that a side that comes is no later than here, and one that goes no
// earlier. With u' = 2^-52, which bounds an operation in any rounding mode, a time is off by u' for the difference, u'
// for `gap_min`, u' for the inverse, u' for its factor and u' for the product: the factors 1 -+ 2^-48 take 16 u' off,
// or add them. Where subnormal numbers are flushed to zero, differences and coordinates are off by 3 * 2^-1022, which
// is below 2^-60 of the 2^-960 that gaps are taken to be smaller by where a side comes, and larger where one goes.
// Speeds below 2^-1000 and above 2^1000 are taken for those, or for infinite, whichever proves less. So no inverse is
// subnormal. A product that is subnormal or flushed to zero is off by less than 2^-1021; so a box is left out where it
// comes later than it goes by more than 2^-1000. Gaps that overflow are at least the largest double. What is no number,
// 0 times infinity, proves nothing.
//
// All steps are monotone, so that of a box within another one the time is no less.
class MovingBox {
  public:
    explicit MovingBox(const Segment& segment) noexcept;
    explicit MovingBox(const Ray& ray) noexcept;
    MovingBox(const Aabb& box, const Vec3& motion) noexcept;

    // At most the first time, from 0 on, at which the two share a point, but for the rounding of what is subnormal;
    // infinity only if they share none at any.
    double meets_from(const Aabb& box) const noexcept;

    // No box that is met at a time that rounds to the limit, to nearest, or before has a later one than this: of what
    // is subnormal a mode that rounds up makes one more.
    static double latest(double limit) noexcept { return limit < subnormal_below ? next_up(limit) : limit; }

    enum class Course : std::uint8_t { coming, going, resting, without_end };
    struct Side {
        Course course = Course::without_end;
        double end = 0;        // p
        std::int64_t key = 0;  // of p
        double factor = 0;     // inverse of the speed
    };

    // The sides whose partners are the minima of boxes, axis by axis, and those whose partners are the maxima. The
    // latter are mirrored: e and p are the negatives of coordinates.
    const std::array<Side, 6>& sides() const noexcept { return sides_; }

    static constexpr double gap_min = 0x1p-960, time_min = 0x1p-1000, number_max = std::numeric_limits<double>::max();
    static constexpr double subnormal_below = 0x1p-1021;

  private:
    void set(std::size_t side, double p, double velocity) noexcept;

    std::array<Side, 6> sides_;
};

// The order of what is compared matters where a time is no number: it then changes nothing.
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
