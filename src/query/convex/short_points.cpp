#include "query/convex/short_points.hpp"

#include <algorithm>
#include <bit>

#include "base/assert.hpp"

namespace ecods::convex {
namespace {

using exact::Int128;
using exact::Uint128;

// Digits of a short number: magnitudes are below 2^62.
constexpr int short_bits = 62;

struct Bits {
    std::uint64_t digits;
    int biased;  // its unit is 2^(biased - 1075)
    bool is_negative;

    explicit Bits(double x) noexcept {
        const auto bits = std::bit_cast<std::uint64_t>(x);
        const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
        digits = (bits & ((std::uint64_t{1} << 52) - 1)) | std::uint64_t{exponent != 0} << 52;
        biased = std::max(exponent, 1);
        is_negative = bits >> 63 != 0;
    }
};

// x in units of 2^(biased - 1022 - short_bits), for |x| < 2^(biased - 1022). Returns whether that is an integer.
bool to_short(double x, int biased, std::int64_t& result) noexcept {
    const Bits bits(x);
    const int up = short_bits - 53 - (biased - bits.biased);
    std::uint64_t size = bits.digits;
    if (up >= 0) {
        size <<= up;
    } else {
        if (size != 0 && std::countr_zero(size) < -up) return false;
        size = size == 0 ? 0 : size >> -up;
    }
    result = bits.is_negative ? -static_cast<std::int64_t>(size) : static_cast<std::int64_t>(size);
    return true;
}

bool has_digits_below(Int128 x, int shift) noexcept {
    return (static_cast<Uint128>(x) & ((Uint128{1} << std::min(shift, 127)) - 1)) != 0;
}

}  // namespace

// A sum of three products of short numbers is below 2^125.6; it loses six digits or more, which leaves less than 2^120.
// A difference of translations is below 2^121, so that a point of the second hull, and its difference from one of the
// first, is below 2^122.
bool ShortPoints::bind(const Pose& a, const SupportPoints& points_a, const Pose& b, const SupportPoints& points_b,
                       double reach) noexcept {
    is_exact_ = true;
    std::array<int, 2> units{};
    unit_ = Bits(reach).biased - 1021 - 120;
    for (const std::size_t side : {0, 1}) {
        Body& body = bodies_[side];
        const Mat3& R = side == 0 ? a.R : b.R;
        body.points = side == 0 ? &points_a : &points_b;
        if (!body.points->has_all_digits) return false;
        int biased = 0;
        for (int i = 0; i < 9; ++i) biased = std::max(biased, Bits(R.data()[i]).biased);
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double r = R(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
                if (!to_short(r, biased, body.rows[row][k])) return false;
            }
        }
        units[side] = biased - 1022 - 2 * short_bits + body.points->exponent;
        unit_ = std::max(unit_, units[side] + 6);
        body.offset = {};
    }
    for (const std::size_t side : {0, 1}) bodies_[side].shift = unit_ - units[side];
    for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        set_offset(k, b.t[row], a.t[row]);
    }
    return true;
}

// Modulo 2^128, in which the difference fits, whatever its terms.
void ShortPoints::set_offset(std::size_t k, double t, double t0) noexcept {
    const auto term = [&](double x) -> Uint128 {
        const Bits bits(x);
        const int up = bits.biased - 1075 - unit_;
        const Int128 m = bits.is_negative ? -Int128{bits.digits} : Int128{bits.digits};
        if (up >= 0) return up < 128 ? static_cast<Uint128>(m) << up : 0;
        is_exact_ &= !has_digits_below(m, -up);
        return static_cast<Uint128>(m >> std::min(-up, 127));
    };
    const Uint128 first = term(t), second = term(t0);
    bodies_[1].offset[k] = static_cast<Int128>(first - second);
}

bool ShortPoints::find(std::size_t side, std::uint32_t vertex, exact::IntegerVector& point) noexcept {
    const Body& body = bodies_[side];
    const exact::Point v = body.points->at(vertex);
    std::array<std::int64_t, 3> x;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!to_short(v[k], 1022, x[k])) return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& r = body.rows[k];
        const Int128 sum = (Int128{r[0]} * x[0] + Int128{r[1]} * x[1]) + Int128{r[2]} * x[2];
        is_exact_ &= !has_digits_below(sum, body.shift);
        point[k] = (sum >> std::min(body.shift, 127)) + body.offset[k];
    }
    return true;
}

}  // namespace ecods::convex
