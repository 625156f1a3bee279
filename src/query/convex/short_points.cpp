#include "query/convex/short_points.hpp"

#include <algorithm>

#include "base/outward.hpp"
#include "exact/point/pose_terms.hpp"

namespace ecods::convex {

using exact::Uint128;

// Chooses the unit in which the points of both hulls are below 2^122. A sum of three products of short numbers is below
// 2^125.6; if six or more digits are dropped, less than 2^120 is left. A difference of translations is below 2^121. So
// a point of the second hull is below 2^122, and so is its difference from a point of the first hull.
bool ShortPoints::bind(const Pose& a, const SupportPoints& points_a, const Pose& b, const SupportPoints& points_b,
                       double reach) noexcept {
    lost_ = 0;
    std::array<int, 2> units{};
    unit_ = static_cast<int>(magnitude_of(reach) >> 52) - 1021 - 120;
    for (const std::size_t side : {0, 1}) {
        Body& body = bodies_[side];
        body.points = side == 0 ? &points_a : &points_b;
        if (!body.points->has_all_digits || !body.R.bind(side == 0 ? a.R : b.R)) return false;
        units[side] = body.R.unit() + body.points->exponent - exact::short_bits;
        unit_ = std::max(unit_, units[side] + 6);
        body.offset = {};
    }
    for (const std::size_t side : {0, 1}) {
        bodies_[side].shift = std::min(unit_ - units[side], 127);
        bodies_[side].below = (Uint128{1} << bodies_[side].shift) - 1;
    }
    exact::DifferenceTerms difference;
    difference.set(b.t, a.t);
    bodies_[1].offset = difference.in<exact::Int128>(unit_);
    for (std::size_t k = 0; k < 3; ++k) {
        for (const exact::DyadicDifference& term : difference[k]) {
            const int down = std::clamp(unit_ - term.e, 0, 127);
            lost_ |= static_cast<Uint128>(term.m) & ((Uint128{1} << down) - 1);
        }
    }
    return true;
}

bool ShortPoints::find(std::size_t side, std::uint32_t vertex, exact::IntegerVector& point) noexcept {
    const Body& body = bodies_[side];
    const exact::Point v = body.points->at(vertex);
    std::array<std::int64_t, 3> x;
    bool are_short = true;
    for (std::size_t k = 0; k < 3; ++k) are_short &= exact::to_short(v[k], 0x1p62, x[k]);
    point = body.R.times(x);
    for (std::size_t k = 0; k < 3; ++k) {
        lost_ |= static_cast<Uint128>(point[k]) & body.below;
        point[k] = (point[k] >> body.shift) + body.offset[k];
    }
    return are_short;
}

}  // namespace ecods::convex
