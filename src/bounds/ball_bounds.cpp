#include "bounds/ball_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/assert.hpp"
#include "base/double_key.hpp"
#include "exact/number/dyadic.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {
namespace {

using namespace exact;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A gap is the distance x - y >= 0 of the center from the box on one axis; x = y = 0 if the center is within the box on
// this axis.
struct Gap {
    double x = 0;
    double y = 0;
};

Gap gap_of(double center, double min, double max) noexcept {
    if (key_of(min) > key_of(center)) return {min, center};
    if (key_of(center) > key_of(max)) return {center, max};
    return {};
}

// is_within_short() takes numbers of at most this many digits. Differences have at most 62 digits, squares 124, and
// sums of three squares 126, which an Int128 holds.
constexpr int short_width = 61;

bool is_within_short(const std::array<Gap, 3>& gaps, double radius, int low) noexcept {
    const auto at_low = [low](double v) {
        const Dyadic x = decode(v);
        return x.m == 0 ? Int128{0} : Int128{x.m} << (x.e - low);
    };
    Int128 sum = 0;
    for (const Gap& gap : gaps) {
        const Int128 difference = at_low(gap.x) - at_low(gap.y);
        sum += difference * difference;
    }
    return sum <= at_low(radius) * at_low(radius);
}

// Numbers are multiples of 2^-1074. In that unit doubles are below 2^2098, and differences of two below 2^2099.
constexpr int limb_count = 33, lowest = -1074;
static_assert(limb_count * 64 > 1024 - lowest + 1 + 1 && 2 * limb_count * 64 > 2 * (1024 - lowest + 1) + 2 + 1);

bool is_within(const std::array<Gap, 3>& gaps, double radius) noexcept {
    Limbs<2 * limb_count> sum{};
    const auto add_square = [&sum](const Limbs<limb_count>& v, std::uint64_t negative) {
        add_signed<2 * limb_count>(sum, multiply<limb_count, limb_count>(v, v), negative);
    };
    const auto add = [](Limbs<limb_count>& v, std::int64_t m, int e) {
        if (m != 0) add_shifted<limb_count>(v, Int128{m}, e - lowest);
    };
    for (const Gap& gap : gaps) {
        const Dyadic x = decode(gap.x), y = decode(gap.y);
        Limbs<limb_count> difference{};
        add(difference, x.m, x.e);
        add(difference, -y.m, y.e);
        add_square(difference, 0);
    }
    const Dyadic r = decode(radius);
    Limbs<limb_count> limbs{};
    add(limbs, r.m, r.e);
    add_square(limbs, all_ones);
    return sign<2 * limb_count>(sum) <= 0;
}

}  // namespace

// Sets a box that contains the ball. c - r has a rounding error of u' (|c| + r), and the subtraction of the margin has
// another u' (|c| + r), with u' = 2^-52. The margin is 4 u' (|c| + r), plus 2^-1000 for underflow.
// Claim: verify/proofs/small_bounds.py
BallBounds::BallBounds(const Ball& ball) noexcept : ball_(ball), square_(ball.radius * ball.radius) {
    ECODS_ASSERT(key_of(ball.radius) >= 0);
    for (int k = 0; k < 3; ++k) {
        ECODS_ASSERT(is_finite(ball.center[k]));
        const double margin = 4 * two_u * (std::abs(ball.center[k]) + ball.radius) + 0x1p-1000;
        box_.min[k] = ball.radius < infinity ? (ball.center[k] - ball.radius) - margin : -infinity;
        box_.max[k] = ball.radius < infinity ? (ball.center[k] + ball.radius) + margin : infinity;
    }
}

BoxVerdict BallBounds::judge(const Aabb& box) const noexcept {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const double gap = std::max(box.min[k] - ball_.center[k], ball_.center[k] - box.max[k]);
        if (gap > 0) sum += gap * gap;
    }
    const double larger = std::max(sum, square_);
    if (!(larger > 0x1p-900 && larger < 0x1p900)) return BoxVerdict::unknown;
    const double bound = 16 * two_u * larger;
    if (sum > square_ + bound) return BoxVerdict::apart;
    return square_ > sum + bound ? BoxVerdict::meeting : BoxVerdict::unknown;
}

bool BallBounds::meets(const Aabb& box) const noexcept {
    if (key_of(ball_.radius) == key_of(infinity)) return true;
    const BoxVerdict verdict = judge(box);
    if (verdict != BoxVerdict::unknown) return verdict == BoxVerdict::meeting;
    std::array<Gap, 3> gaps;
    BitRange range;
    range.include(decode(ball_.radius));
    for (int k = 0; k < 3; ++k) {
        Gap& gap = gaps[static_cast<std::size_t>(k)];
        gap = gap_of(ball_.center[k], box.min[k], box.max[k]);
        // The whole box is at infinity on this axis, which no finite ball reaches.
        if (key_of(gap.x) == key_of(infinity) || key_of(gap.y) == key_of(-infinity)) return false;
        range.include(decode(gap.x));
        range.include(decode(gap.y));
    }
    return range.width() <= short_width ? is_within_short(gaps, ball_.radius, range.low)
                                        : is_within(gaps, ball_.radius);
}

bool overlap(const Ball& ball, const Aabb& box) noexcept {
    return BallBounds(ball).meets(box);
}

}  // namespace ecods
