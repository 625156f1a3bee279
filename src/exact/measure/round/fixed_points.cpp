#include "exact/measure/round/fixed_points.hpp"

#include <algorithm>
#include <bit>

namespace ecods::exact {

void FixedPoints::bind(const BodyRef& a, const BodyRef& b, const BitRange& others) noexcept {
    bodies_[0].ref = a;
    bodies_[1].ref = b;
    find_unit(others);
    for (Body& body : bodies_) {
        body.points.clear();
        const Pose& pose = *body.ref.pose;
        for (int row = 0; row < 3; ++row) {
            const auto r = static_cast<std::size_t>(row);
            for (int column = 0; column < 3; ++column) {
                body.columns[static_cast<std::size_t>(column)][r] = factor(pose.R(row, column));
            }
            const Dyadic t = decode(pose.t[row]), t0 = decode(bodies_[0].ref.pose->t[row]);
            // Modulo 2^128, in which the difference fits, whatever its terms.
            const auto first = static_cast<Uint128>(shifted(t.m, t.e - unit_));
            const auto second = static_cast<Uint128>(shifted(t0.m, t0.e - unit_));
            body.offset[r] = static_cast<Int128>(first - second);
        }
    }
}

// A coordinate is the sum of three products and a difference of translations, each below 2^high: the difference of two
// coordinates is below 2^(high + 3), and difference_bits hold it.
void FixedPoints::find_unit(const BitRange& others) noexcept {
    BitRange digits;
    for (const Body& body : bodies_) {
        for (int column = 0; column < 3; ++column) {
            BitRange r;
            for (int row = 0; row < 3; ++row) r.include(decode(body.ref.pose->R(row, column)));
            digits.include(r * body.ref.extent->digits[static_cast<std::size_t>(column)]);
        }
    }
    for (int row = 0; row < 3; ++row) {
        const Dyadic t0 = decode(bodies_[0].ref.pose->t[row]), t = decode(bodies_[1].ref.pose->t[row]);
        if (const auto difference = subtract(t, t0)) {
            digits.include(difference->digits());
        } else {  // Too far apart in scale to cancel.
            digits.include(t0);
            digits.include(t);
            digits.include(digits.low, digits.high + 1);
        }
    }
    BitRange all = digits;
    all.include(others);
    if (all.width() + 3 <= difference_bits) digits = all;
    is_exact_ = digits.width() + 3 <= difference_bits;
    unit_ = digits.empty() ? 0 : std::max(digits.low, digits.high + 3 - difference_bits);
}

FixedPoints::Factor FixedPoints::factor(double x) noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const auto m = static_cast<std::int64_t>(biased == 0 ? fraction : fraction | std::uint64_t{1} << 52);
    return {bits >> 63 ? -m : m, (biased == 0 ? 1 : biased) - 1075};
}

// m 2^shift modulo 2^128, rounded down.
inline Int128 FixedPoints::shifted(Int128 m, int shift) noexcept {
    if (shift >= 0) return shift < 128 ? static_cast<Int128>(static_cast<Uint128>(m) << shift) : 0;
    return m >> std::min(-shift, 127);
}

void FixedPoints::pose(const Body& of, std::uint32_t vertex, Point& p) const noexcept {
    p = of.offset;
    const Vec3& v = of.ref.mesh->vertices()[vertex];
    for (std::size_t column = 0; column < 3; ++column) {
        const Factor x = factor(v[static_cast<Eigen::Index>(column)]);
        if (x.m == 0) continue;
        for (std::size_t row = 0; row < 3; ++row) {
            const Factor& r = of.columns[column][row];
            if (r.m == 0) continue;
            p[row] += shifted(Int128{r.m} * x.m, r.e + x.e - unit_);
        }
    }
}

}  // namespace ecods::exact
