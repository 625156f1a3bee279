#include "query/convex/short_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/outward.hpp"
#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::convex {
namespace {

using exact::Int128;
using exact::Uint128;

// Digits of a short number: magnitudes are below 2^62.
constexpr int short_bits = 62;

// The exponents that `power` and numbers may have: no product of them underflows, in any mode.
constexpr double size_min = 0x1p-500;
constexpr int power_max = 480;

// x times a power of two that leaves it below 2^62, for |x| >= size_min or zero. Returns whether that is an integer:
// multiplied and converted exactly, and back without a rounding if no digits were cut off.
bool to_short(double x, double power, std::int64_t& result) noexcept {
    const double scaled = x * power;
    result = static_cast<std::int64_t>(scaled);
    return static_cast<double>(result) == scaled;
}

// By bits, as subnormal numbers may be taken for zero: the exponent as it is biased of the largest magnitude; 0 where a
// number that is not zero is below size_min.
int biased_exponent(const Mat3& R) noexcept {
    constexpr std::uint64_t least = magnitude_of(size_min);
    std::uint64_t most = 0;
    bool are_ordinary = true;
    for (int i = 0; i < 9; ++i) {
        const std::uint64_t size = magnitude_of(R.data()[i]);
        most = std::max(most, size);
        are_ordinary &= size == 0 || size >= least;
    }
    return are_ordinary ? static_cast<int>(most >> 52) : 0;
}

}  // namespace

// A sum of three products of short numbers is below 2^125.6; it loses six digits or more, which leaves less than 2^120.
// A difference of translations is below 2^121, so that a point of the second hull, and its difference from one of the
// first, is below 2^122.
bool ShortPoints::bind(const Pose& a, const SupportPoints& points_a, const Pose& b, const SupportPoints& points_b,
                       double reach) noexcept {
    lost_ = 0;
    std::array<int, 2> units{};
    unit_ = static_cast<int>(magnitude_of(reach) >> 52) - 1021 - 120;
    for (const std::size_t side : {0, 1}) {
        Body& body = bodies_[side];
        const Mat3& R = side == 0 ? a.R : b.R;
        body.points = side == 0 ? &points_a : &points_b;
        const int biased = biased_exponent(R), up = short_bits - (biased - 1022);
        if (!body.points->has_all_digits || biased == 0 || std::abs(up) > power_max) return false;
        const double power = exact::power_of_two(up);
        bool are_short = true;
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double r = R(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
                are_short &= to_short(r, power, body.rows[row][k]);
            }
        }
        if (!are_short) return false;
        units[side] = body.points->exponent - up - short_bits;
        unit_ = std::max(unit_, units[side] + 6);
        body.offset = {};
    }
    for (const std::size_t side : {0, 1}) {
        bodies_[side].shift = std::min(unit_ - units[side], 127);
        bodies_[side].below = (Uint128{1} << bodies_[side].shift) - 1;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        set_offset(k, b.t[row], a.t[row]);
    }
    return true;
}

// Modulo 2^128, in which the difference fits, whatever its terms.
void ShortPoints::set_offset(std::size_t k, double t, double t0) noexcept {
    const auto term = [&](double x) -> Uint128 {
        const auto bits = std::bit_cast<std::uint64_t>(x);
        const int biased = static_cast<int>(bits >> 52 & 0x7ff);
        const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
        const Int128 size = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
        const Int128 m = bits >> 63 ? -size : size;
        const int up = std::max(biased, 1) - 1075 - unit_;
        if (up >= 0) return up < 128 ? static_cast<Uint128>(m) << up : 0;
        const int down = std::min(-up, 127);
        lost_ |= static_cast<Uint128>(m) & ((Uint128{1} << down) - 1);
        return static_cast<Uint128>(m >> down);
    };
    const Uint128 first = term(t), second = term(t0);
    bodies_[1].offset[k] = static_cast<Int128>(first - second);
}

bool ShortPoints::find(std::size_t side, std::uint32_t vertex, exact::IntegerVector& point) noexcept {
    const Body& body = bodies_[side];
    const exact::Point v = body.points->at(vertex);
    std::array<std::int64_t, 3> x;
    bool are_short = true;
    for (std::size_t k = 0; k < 3; ++k) are_short &= to_short(v[k], 0x1p62, x[k]);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& r = body.rows[k];
        const Int128 sum = (Int128{r[0]} * x[0] + Int128{r[1]} * x[1]) + Int128{r[2]} * x[2];
        lost_ |= static_cast<Uint128>(sum) & body.below;
        point[k] = (sum >> body.shift) + body.offset[k];
    }
    return are_short;
}

}  // namespace ecods::convex
