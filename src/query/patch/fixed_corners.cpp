#include "query/patch/fixed_corners.hpp"

#include <algorithm>
#include <cmath>

#include "base/double_key.hpp"
#include "exact/measure/round/fixed_crossing.hpp"
#include "exact/measure/round/fixed_digits.hpp"
#include "exact/number/power.hpp"

namespace ecods::patches {
namespace {

using convex::HullFeaturePair;
using exact::FixedNumber;
using exact::FixedShift;
using exact::IntegerVector;
using Kind = Feature::Kind;

FixedNumber twice(const FixedNumber& x) noexcept {
    return x + x;
}

}  // namespace

std::optional<FixedCorners> FixedCorners::of(convex::PosedHulls& hulls, const convex::LeastDifference& least,
                                             const exact::Radii& radii) {
    FixedCorners result(hulls, radii);
    if (!result.bind() || !result.find_shift(least)) return std::nullopt;
    return result;
}

// Sets unit_ such that the coordinates of points, the translation and the radii are below 2^120 units, and sums of two
// of them below 2^121. Returns false if all numbers are zero, or if the unit or the error of the points is too large
// beside unit_.
bool FixedCorners::bind() {
    constexpr int digits = 120;
    const bool is_exact = hulls_->has_fixed_points();
    const Vec3& t = hulls_->reference({0, 0}).pose->t;
    int high = std::max(exact::exponent_above(radii_.a), exact::exponent_above(radii_.b));
    for (const double x : t) high = std::max(high, exact::exponent_above(x));
    high = std::max(high, hulls_->fixed_high());
    if (high < -2000) return false;  // all numbers are zero
    unit_ = high - digits;
    up_ = hulls_->fixed_unit() - unit_;
    if (up_ > (is_exact ? 120 : 15)) return false;
    if (!is_exact) error_ = (std::uint64_t{exact::IntegerFrame::error_units} << std::max(up_, 0)) + 1;
    if (error_ >> 18 != 0) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const FixedNumber x = exact::fixed_number(t[static_cast<Eigen::Index>(k)], unit_);
        origin_.x[k] = x.value;
        origin_.error = std::max(origin_.error, static_cast<std::uint64_t>(x.error));
    }
    return true;
}

auto FixedCorners::at(std::size_t side, std::uint32_t vertex) const -> WorldPoint {
    const IntegerVector& from = hulls_->fixed({side, vertex});
    WorldPoint point{origin_.x, error_ + origin_.error};
    if (up_ >= 0) {
        for (std::size_t k = 0; k < 3; ++k) point.x[k] += from[k] << up_;
        return point;
    }
    const int down = std::min(-up_, 127);
    exact::Int128 lost = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const exact::Int128 kept = from[k] >> down;
        lost |= from[k] ^ (kept << down);
        point.x[k] += kept;
    }
    if (lost != 0) ++point.error;
    return point;
}

std::array<FixedCorners::WorldPoint, 2> FixedCorners::ends_of(std::size_t side, std::uint32_t edge) const {
    const auto& ends = hulls_->hull(side).edges[edge].ends;
    return {at(side, ends[0]), at(side, ends[1])};
}

// Sets shift_ to the vector w (fixed_corners.hpp) and to its direction, from a to b, or out of a if the difference is a
// depth. Computes w from the features that have the least difference. Returns false if fixed precision does not
// determine w.
bool FixedCorners::find_shift(const convex::LeastDifference& least) {
    std::array<std::array<IntegerVector, 3>, 2> x;
    std::array<std::size_t, 2> count{};
    std::uint64_t error = 0;
    for (const std::size_t side : {0, 1}) {
        for (const std::uint32_t vertex : least.found.of_side(side)) {
            const WorldPoint point = at(side, vertex);
            x[side][count[side]++] = point.x;
            error = std::max(error, 2 * point.error);
        }
    }
    const IntegerVector w = exact::difference(x[1][0], x[0][0]);
    const auto edge = [&](std::size_t side, std::size_t to) { return exact::difference(x[side][to], x[side][0]); };
    const std::size_t of = count[0] > 1 ? 0 : 1;
    if (count[0] == 2 && count[1] == 2) {
        shift_ = FixedShift::across_plane(edge(0, 1), edge(1, 1), w, error);
    } else if (count[of] == 3) {
        shift_ = FixedShift::across_plane(edge(of, 1), edge(of, 2), w, error);
    } else if (count[of] == 2) {
        shift_ = FixedShift::across_line(edge(of, 1), w, error);
    } else {
        shift_ = FixedShift::of_vector(w, error);
    }
    if (!shift_) return false;
    Eigen::Index most = 0;
    least.normal.cwiseAbs().maxCoeff(&most);
    most_ = static_cast<std::size_t>(most);
    if ((shift_->direction(most_).value < 0) != (least.normal[most] < 0)) shift_->turn();
    if (least.is_zero) shift_->vanish();
    return true;
}

void FixedCorners::set_vertex(const HullFeaturePair& pair, Coordinates& to) const {
    const bool is_a = pair[0].kind == Kind::vertex;
    const WorldPoint point = at(is_a ? 0 : 1, pair[is_a ? 0 : 1].index);
    for (std::size_t k = 0; k < 3; ++k) {
        const FixedNumber x{point.x[k], point.error}, &w = (*shift_)[k];
        to.a[k] = is_a ? x : x - w;
        to.b[k] = is_a ? x + w : x;
        to.sum[k] = is_a ? twice(x) + w : twice(x) - w;
    }
    if (!is_a || pair[1].kind != Kind::vertex) return;
    const WorldPoint other = at(1, pair[1].index);
    for (std::size_t k = 0; k < 3; ++k) {
        to.b[k] = {other.x[k], other.error};
        to.sum[k] = to.a[k] + to.b[k];
    }
}

// Sets the points at which edge u of the first body and edge v of the second body, moved by -w, cross. If a coordinate
// is constant and exact along v, but not constant along u, takes the coordinate from v; otherwise computes it from u.
bool FixedCorners::set_crossing(const HullFeaturePair& edges, Coordinates& to) const {
    const auto p = ends_of(0, edges[0].index), q = ends_of(1, edges[1].index);
    const std::uint64_t of_p = p[0].error + p[1].error, of_q = q[0].error + q[1].error;
    const IntegerVector u = exact::difference(p[1].x, p[0].x), v = exact::difference(q[1].x, q[0].x);
    const std::size_t i = (most_ + 1) % 3, j = (most_ + 2) % 3;
    const auto way = [&](std::size_t k) {
        return FixedNumber{q[0].x[k] - p[0].x[k], p[0].error + q[0].error} - (*shift_)[k];
    };
    const auto s = exact::find_crossing({way(i), way(j)}, {u[i], u[j]}, {v[i], v[j]}, std::max(of_p, of_q));
    if (!s) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const FixedNumber& w = (*shift_)[k];
        if (v[k] == 0 && of_q == 0 && u[k] != 0) {
            const FixedNumber y{q[0].x[k], 0};
            to.a[k] = y - w;
            to.b[k] = y;
            to.sum[k] = twice(y) - w;
        } else {
            const FixedNumber x = FixedNumber{p[0].x[k], p[0].error} + s->times(u[k], of_p);
            to.a[k] = x;
            to.b[k] = x + w;
            to.sum[k] = twice(x) + w;
        }
    }
    return true;
}

// Moves both points of a corner from the surfaces of the cores to the surfaces of the rounded bodies.
void FixedCorners::add_radii(Coordinates& to) const noexcept {
    const exact::FixedRadius of_a(radii_.a, unit_), of_b(radii_.b, unit_);
    for (std::size_t k = 0; k < 3; ++k) {
        const FixedNumber& n = shift_->direction(k);
        const FixedNumber x = of_a.times(n), y = of_b.times(n);
        to.a[k] = to.a[k] + x;
        to.b[k] = to.b[k] - y;
        to.sum[k] = to.sum[k] + (x - y);
    }
}

// Rounds a coordinate once if it is the same in both points, as coordinates across the normal often are.
bool FixedCorners::round(const HullFeaturePair& pair, PatchCorner& corner) const {
    Coordinates of;
    if (pair[0].kind == Kind::vertex || pair[1].kind == Kind::vertex) {
        set_vertex(pair, of);
    } else if (!set_crossing(pair, of)) {
        return false;
    }
    const bool has_radii = key_of(radii_.a) != 0 || key_of(radii_.b) != 0;
    if (has_radii) add_radii(of);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        const std::optional<double> a = of.a[k].rounded(unit_);
        if (!a) return false;
        corner.point_a[row] = corner.point_b[row] = corner.middle[row] = *a;
        const FixedNumber& w = (*shift_)[k];
        if (!has_radii && w.value == 0 && w.error == 0) continue;
        const std::optional<double> b = of.b[k].rounded(unit_), middle = of.sum[k].rounded(unit_ - 1);
        if (!b || !middle) return false;
        corner.point_b[row] = *b;
        corner.middle[row] = *middle;
    }
    return true;
}

std::optional<IntegerVector> FixedCorners::way() const noexcept {
    if (up_ < 0 || error_ != 0) return std::nullopt;
    IntegerVector result;
    for (std::size_t k = 0; k < 3; ++k) {
        if ((*shift_)[k].error != 0) return std::nullopt;
        result[k] = (*shift_)[k].value >> up_;
    }
    return result;
}

std::optional<double> FixedCorners::distance() const noexcept {
    using exact::fixed_number;
    const FixedNumber gap = shift_->length() - (fixed_number(radii_.a, unit_) + fixed_number(radii_.b, unit_));
    return gap.rounded_distance(unit_);
}

}  // namespace ecods::patches
