#include "bvh/axes/far_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/outward.hpp"
#include "bvh/axes/posed_axes.hpp"

namespace ecods {

// Holds the trees projected on one axis n, along the vector between their centers. n is a row of the matrix N of
// far_gap.hpp.
struct FarRow {
    double length;
    double a[3], b[3];
    double gap, margin, sum;
};

}  // namespace ecods

#define ECODS_TEXT "bvh/axes/far_gap_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {
namespace {

using namespace axes;

constexpr double unit_max = 0x1p400;

}  // namespace

void FarGap::bind(const DistanceAxes& axes, const PosedTree& tree_a, const PosedTree& tree_b, const Vec3& d) {
    is_far_ = false;
    const DistanceSet& set = axes.sets()[0];
    unit_ = axes.unit();
    if (is_near(set) || !(unit_ < unit_max && unit_ > 1 / unit_max)) return;
    const FarRow row = call_widest<ECODS_OF_EACH_SET(row_along)>(tree_a, tree_b, d, unit_);
    if (!(row.margin < infinity && row.length >= 0.5 && row.length < 2)) return;
    is_far_ = true;
    length_ = row.length;
    gap_ = row.gap;
    for (std::size_t k = 0; k < 3; ++k) {
        a[k] = static_cast<float>(row.a[k]);
        b[k] = static_cast<float>(row.b[k]);
    }
    reach = static_cast<float>(row.sum);
    margin_ = row.margin + 24 * float_u * row.sum + underflow;
}

float FarGap::rank_above(double distance) const noexcept {
    const double own = static_cast<double>(reach);
    const double at = length_ * (distance / unit_) * (1 + 0x1p-48);
    const double rank = ((at - gap_) + own) + margin_;
    const double rounding = 0x1p-49 * (((at + std::abs(gap_)) + own) + margin_);
    // No rank is above 3 reach, up to rounding, so a limit of 4 reach + 1 excludes no pair.
    const double all = 4 * own + 1;
    return round_up(std::min(std::max(rank + rounding, 0.0), all));
}

}  // namespace ecods
