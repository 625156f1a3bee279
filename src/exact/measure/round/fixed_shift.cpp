// The errors of products with directions are bounded as follows. Let n be a coordinate of a direction, |n| <= 2^126,
// off by less than a < 2^63, and x a number that is off by less than b, both in their units. The product is off by |n|
// b 2^-126 <= b; |x| a 2^-126, of which the code has the part above 2^62 of |x|, cut, less than 2 units too little; a b
// 2^-126 < b 2^-63, less than b 2^-62 cut and 1; and by less than 1 for its own cut. The directions of a FixedVector
// may be greater than 1, by less than a. So b counts once more, and 5 units cover all cuts. An exact n is 0 or 1 or -1,
// and its product is exact.
//
// The coordinates of a normal u x v are differences of two products. Each is off by U e + V e + e^2, where U and V are
// upper bounds of coordinates. Cut to 120 digits, they lose less than a unit, and so does the bound of their errors.
// Claim: verify/proofs/fixed_shift.py
#include "exact/measure/round/fixed_shift.hpp"

#include <algorithm>

#include "exact/measure/round/fixed_digits.hpp"

namespace ecods::exact {
namespace {

FixedNumber opposite(const FixedNumber& x) noexcept {
    return {-x.value, x.error};
}

bool is_zero(const FixedNumber& x) noexcept {
    return x.value == 0 && x.error == 0;
}

// Returns the leading digits of u x v, for differences u and v of points; nullopt if the product may be zero.
std::optional<FixedVector> normal_of(const IntegerVector& u, const IntegerVector& v, std::uint64_t error) noexcept {
    constexpr int digits = 120;
    const WideVector n = cross(u, v);
    const int shift = bit_width(n) - digits;
    if (shift <= -digits) return std::nullopt;
    std::uint64_t off = shift > 0 ? 1 : 0;
    if (error != 0) {
        const Int256 sum =
            multiply(static_cast<Int128>(largest(u) + largest(v) + error), static_cast<Int128>(2 * error));
        if (shift < 0 || bit_width(sum) - shift > 60) return std::nullopt;
        off = static_cast<std::uint64_t>(shifted(sum, shift)) + 2;
    }
    ErrorBounds errors;
    for (std::size_t k = 0; k < 3; ++k) errors[k] = error == 0 && sign(n[k]) == 0 ? 0 : off;
    return FixedVector::of(shifted(n, shift), errors);
}

}  // namespace

FixedNumber times(const FixedNumber& n, const FixedNumber& x) noexcept {
    if (is_zero(n) || is_zero(x)) return {};
    if (n.error == 0) return n.value < 0 ? opposite(x) : x;
    const Int128 value = shifted(multiply(n.value, x.value), FixedVector::unit_digits);
    const Uint128 of_n = ((size_of(x.value) >> 62) * static_cast<std::uint64_t>(n.error)) >> 64;
    return {value, x.error + 2 * (x.error >> 62) + of_n + 5};
}

// Sets direction_ to the unit vector of `along`; returns false if `along` is nullopt or an error bound is too large.
bool FixedShift::set_direction(const std::optional<FixedVector>& along) noexcept {
    if (!along) return false;
    bool is_known = true;
    for (std::size_t k = 0; k < 3; ++k) {
        direction_[k] = along->direction(k);
        is_known &= direction_[k].error >> 63 == 0;
    }
    return is_known;
}

// Returns the dot product of the unit vector direction_ and w.
FixedNumber FixedShift::product(const IntegerVector& w, std::uint64_t error) const noexcept {
    FixedNumber sum;
    for (std::size_t k = 0; k < 3; ++k) sum = sum + times(direction_[k], {w[k], error});
    return sum;
}

std::optional<FixedShift> FixedShift::of_vector(const IntegerVector& w, std::uint64_t error) noexcept {
    const auto along = FixedVector::of(w, {error, error, error});
    FixedShift result;
    if (!result.set_direction(along)) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) result.shift_[k] = {w[k], error};
    result.length_ = along->length(0);
    return result;
}

// Returns w - (d . w) d, the part of w across the line, where d is the unit vector along u. |w| is below 2^123, and so
// is the length of the result.
std::optional<FixedShift> FixedShift::across_line(const IntegerVector& u, const IntegerVector& w,
                                                  std::uint64_t error) noexcept {
    FixedShift result;
    if (!result.set_direction(FixedVector::of(u, {error, error, error}))) return std::nullopt;
    const FixedNumber along = result.product(w, error);
    IntegerVector rest;
    ErrorBounds errors;
    for (std::size_t k = 0; k < 3; ++k) {
        const FixedNumber of_w{w[k], error};
        result.shift_[k] = of_w - times(result.direction_[k], along);
        if (result.shift_[k].error >> 62 != 0 || size_of(result.shift_[k].value) >> 123 != 0) return std::nullopt;
        rest[k] = result.shift_[k].value;
        errors[k] = static_cast<std::uint64_t>(result.shift_[k].error);
    }
    const auto across = FixedVector::of(rest, errors);
    if (!result.set_direction(across)) return std::nullopt;
    result.length_ = across->length(0);
    return result;
}

std::optional<FixedShift> FixedShift::across_plane(const IntegerVector& u, const IntegerVector& v,
                                                   const IntegerVector& w, std::uint64_t error) noexcept {
    FixedShift result;
    if (!result.set_direction(normal_of(u, v, error))) return std::nullopt;
    result.length_ = result.product(w, error);
    for (std::size_t k = 0; k < 3; ++k) result.shift_[k] = times(result.direction_[k], result.length_);
    return result;
}

void FixedShift::turn() noexcept {
    for (FixedNumber& x : direction_) x = opposite(x);
    length_ = opposite(length_);
}

void FixedShift::vanish() noexcept {
    shift_ = {};
    length_ = {};
}

}  // namespace ecods::exact
