// Quotients by square roots are computed as intervals, in fixed precision, and rounded if all numbers of the interval
// round to the same double. Most intervals do, because their width is about 2^-90 of the number.
#include "exact/measure/round/fixed_plane.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "exact/measure/round/limb_vectors.hpp"
#include "exact/measure/round/squared_distance.hpp"

namespace ecods::exact {

namespace {

exact::LimbVector<2> limbs_of(const FixedPlane::Vector& v) noexcept {
    exact::LimbVector<2> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Uint128 size = size_of(v[k]);
        result[k] = {{static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)},
                     v[k] < 0 ? exact::all_ones : 0};
    }
    return result;
}

exact::LimbVector<4> limbs_of(const std::array<Int256, 3>& v) noexcept {
    exact::LimbVector<4> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Int256 size = size_of(v[k]);
        const auto high = static_cast<Uint128>(size.high);
        result[k] = {{static_cast<std::uint64_t>(size.low), static_cast<std::uint64_t>(size.low >> 64),
                      static_cast<std::uint64_t>(high), static_cast<std::uint64_t>(high >> 64)},
                     v[k].high < 0 ? exact::all_ones : 0};
    }
    return result;
}

}  // namespace

FixedPlane::FixedPlane(const std::array<Vector, 3>& m, int unit, bool is_exact) noexcept
    : m_(m), unit_(unit), is_exact_(is_exact) {
    find_normal();
}

void FixedPlane::find_normal() noexcept {
    const Vector u = exact::difference(m_[1], m_[0]), v = exact::difference(m_[2], m_[0]);
    n_ = cross(u, v);
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (exact::sign(n_[k]) == 0) continue;
        axis_ = static_cast<int>(k);
        ++count;
    }
    if (count != 1 || !is_exact_) axis_ = -1;
    if (axis_ >= 0 || count == 0) return;
    const int shift = bit_width(n_) - 126;
    short_n_ = shifted(n_, shift);
    error_ = shift > 0 ? 1 : 0;
    if (!is_exact_) {
        // The edges u and v are off by 10 units, so their cross product is off by 2 (10 |u| + 10 |v| + 100).
        const Int256 error = exact::multiply(static_cast<Int128>(largest(u) + largest(v) + 10), 20);
        // If edges are short, the error may be almost as large as the normal: then the normal's direction is unknown.
        is_open_ = bit_width(error) - shift > 96;
        if (is_open_) return;
        error_ = static_cast<Uint128>(shifted(error, shift)) + 2;
    }
    root_ = inverse_root(square_of(short_n_));
    find_height();
}

void FixedPlane::find_height() noexcept {
    Uint128 size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        height_ = height_ + exact::multiply(short_n_[k], m_[0][k]);
        size = std::max(size, size_of(m_[0][k]));
    }
    // height_ is a sum of three products. Each is off by error_ (|m| + 5) + 5 * 2^126: |short_n_| < 2^126 is off by
    // error_, and m by 5 units unless points are exact.
    const Int128 points = is_exact_ ? 0 : 5;
    const Int256 one = exact::multiply(static_cast<Int128>(error_), static_cast<Int128>(size) + points) +
                       exact::multiply(points, Int128{1} << 126);
    height_error_ = one + one + one;
}

int FixedPlane::sign_along(const Vector& v) const noexcept {
    if (axis_ >= 0) {
        const auto k = static_cast<std::size_t>(axis_);
        return exact::sign(n_[k]) * exact::sign(v[k]);
    }
    return exact::sign<6>(exact::dot<4, 2>(limbs_of(n_), limbs_of(v)));
}

std::optional<int> FixedPlane::side() const noexcept {
    if (is_open_) return std::nullopt;
    if (is_exact_ && axis_ >= 0) return sign_along(m_[0]);
    const int sign = exact::sign(height_);
    if (sign != 0 && exact::sign(size_of(height_) - height_error_) > 0) return sign;
    if (!is_exact_) return std::nullopt;
    return sign_along(m_[0]);
}

// Returns size / |short_n_| * 2^exponent as an interval. `size` must be below 2^127, and is off by `error`. Returns
// nullopt if the interval would be too wide.
//
// Let P = size root_; its leading 128 digits are the digits of the result. P is off by 2^127 for each unit of error in
// size. Its relative errors are 2^-94 from root_ and 2^-124 error_ from |short_n_|, which is at least 2^125 and off by
// sqrt(3) error_.
// Claim: verify/proofs/fixed_digits.py
auto FixedPlane::quotient(Uint128 size, Uint128 error, int exponent) const noexcept -> std::optional<FixedDigits> {
    if (is_open_ || size == 0 || error >> 64 != 0 || error_ >> 64 != 0) return std::nullopt;
    const Int256 product = exact::multiply_halves(size, root_);
    const int drop = bit_width(product) - 128;
    const int up = 127 - drop;  // shift from the unit of `size` to the unit of the result
    if (up > 0 && error != 0 && exact::bit_width(error) + up > 100) return std::nullopt;
    const Uint128 of_size = up > 0 ? (error != 0 ? error << up : 0) : (error >> std::min(-up, 127)) + 1;
    const Uint128 total = of_size + (Uint128{1} << 34) + (error_ << 4) + 2;
    const Uint128 digits =
        static_cast<Uint128>(drop >= 0 ? shifted(product, drop) : static_cast<Int128>(product.low << -drop));
    return FixedDigits{digits, exponent + drop - 252, total};
}

auto FixedPlane::digits() const noexcept -> std::optional<FixedDigits> {
    if (axis_ >= 0) {
        const Uint128 size = size_of(m_[0][static_cast<std::size_t>(axis_)]);
        const int up = 128 - exact::bit_width(size);
        return FixedDigits{up < 128 ? size << up : 0, unit_ - up, 0};
    }
    const Int256 size = size_of(height_);
    const int drop = std::max(0, bit_width(size) - 126);
    if (bit_width(height_error_) - drop > 63) return std::nullopt;
    return quotient(static_cast<Uint128>(shifted(size, drop)),
                    static_cast<Uint128>(shifted(height_error_, drop)) + (drop > 0 || height_error_.low != 0 ? 1 : 0),
                    unit_ + drop);
}

std::optional<double> FixedPlane::distance() const noexcept {
    if (axis_ >= 0) {
        const Uint128 size = size_of(m_[0][static_cast<std::size_t>(axis_)]);
        return size == 0 ? 0 : at_least_subnormal(exact::round_integer({size, 0}, unit_));
    }
    const std::optional<FixedDigits> all = digits();
    const std::optional<double> rounded = all ? all->rounded() : std::nullopt;
    return rounded ? std::optional(at_least_subnormal(*rounded)) : std::nullopt;
}

std::optional<Vec3> FixedPlane::direction() const noexcept {
    Vec3 result = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        if (axis_ >= 0) {
            if (static_cast<int>(k) == axis_) result[at] = n_[k].high < 0 ? -1 : 1;
            continue;
        }
        if (is_exact_ && exact::sign(n_[k]) == 0) continue;
        const Uint128 size = size_of(short_n_[k]);
        if (size <= error_) return std::nullopt;
        const std::optional<FixedDigits> part = quotient(size, error_, 0);
        const std::optional<double> rounded = part ? part->rounded() : std::nullopt;
        if (!rounded) return std::nullopt;
        result[at] = short_n_[k] < 0 ? -*rounded : *rounded;
    }
    return result;
}

std::optional<int> FixedPlane::compare(const FixedPlane& other) const noexcept {
    if (axis_ >= 0 && other.axis_ >= 0) {
        const Uint128 x = size_of(m_[0][static_cast<std::size_t>(axis_)]);
        const Uint128 y = size_of(other.m_[0][static_cast<std::size_t>(other.axis_)]);
        return static_cast<int>(x > y) - static_cast<int>(x < y);
    }
    const std::optional<FixedDigits> x = digits(), y = other.digits();
    if (!x || !y || x->error >> 96 != 0 || y->error >> 96 != 0) return std::nullopt;
    if (std::abs(x->exponent - y->exponent) >= 2) return x->exponent < y->exponent ? -1 : 1;
    const auto low = [&](const FixedDigits& d, int exponent) {
        return ((d.digits - d.error) >> 2) >> (exponent - d.exponent);
    };
    const auto high = [&](const FixedDigits& d, int exponent) {
        return (((d.digits >> 2) + (d.error >> 2) + 2) >> (exponent - d.exponent)) + 1;
    };
    const int exponent = std::max(x->exponent, y->exponent);
    if (high(*x, exponent) < low(*y, exponent)) return -1;
    if (high(*y, exponent) < low(*x, exponent)) return 1;
    return std::nullopt;
}

}  // namespace ecods::exact
