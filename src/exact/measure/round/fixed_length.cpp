// Lengths are computed from the leading digits x of a vector: the largest coordinate of x has 126 digits, and each
// coordinate is off by less than `error`. Then 2^125 <= |x| < 2^127, and |x| is off by less than sqrt(3) error, which
// is a relative error below 2^-124 error.
//
// A result has 128 leading digits, so it is below 2^128 units of its last digit, and errors are counted in these units.
// A relative error of 2^-94, as of inverse_root(), is below 2^34 units, and a relative error of 2^-124 error is below
// 16 error units.
// Claim: verify/proofs/fixed_digits.py
#include "exact/measure/round/fixed_length.hpp"

#include "exact/measure/round/fixed_digits.hpp"

namespace ecods::exact {
namespace {

struct Leading {
    IntegerVector x{};
    int shift = 0;  // the vector is x 2^shift
    Uint128 error = 0;
};

// Returns the leading digits of v, whose coordinates are off by less than `error`. Returns nullopt if v is zero, or so
// short that the scaled error could be 2^57 or more.
std::optional<Leading> leading(const IntegerVector& v, int error) noexcept {
    const int width = bit_width(largest(v));
    if (width == 0) return std::nullopt;
    const int up = 126 - width;
    if (error != 0 && up > 54) return std::nullopt;
    return Leading{{v[0] << up, v[1] << up, v[2] << up}, -up, static_cast<Uint128>(error) << up};
}

// Returns the leading digits of w x u; coordinates of w and u are off by w_error and u_error. Returns nullopt if the
// product is zero, or too short for its error.
std::optional<Leading> leading_product(const IntegerVector& w, const IntegerVector& u, int w_error,
                                       int u_error) noexcept {
    const WideVector product = cross(w, u);
    const int width = bit_width(product);
    if (width == 0) return std::nullopt;
    const int shift = width - 126;
    Leading result{shifted(product, shift), shift, shift > 0 ? Uint128{1} : 0};
    if (w_error != 0 || u_error != 0) {
        // A coordinate is a difference of two products; each product is off by |w| u_error + |u| w_error + u_error
        // w_error.
        const Int256 one = multiply(static_cast<Int128>(largest(w)) + w_error, u_error) +
                           multiply(static_cast<Int128>(largest(u)), w_error);
        const Int256 both = one + one;
        if (bit_width(both) - shift > 58) return std::nullopt;
        result.error += static_cast<Uint128>(shifted(both, shift)) + 1;
    }
    return result;
}

// Returns |x| 2^125 = (s / 2^127) (2^252 / sqrt(s)), where s = |x|^2. The relative errors are 2^-94 from
// inverse_root(), and 2^-123 from dropping the last 127 digits of s.
Int256 length_of(const IntegerVector& x) noexcept {
    const Int256 s = square_of(x);
    return multiply_halves(static_cast<Uint128>(shifted(s, 127)), inverse_root(s));
}

}  // namespace

std::optional<double> fixed_length(const IntegerVector& w, int unit, bool is_exact) noexcept {
    const auto of = leading(w, is_exact ? 0 : 5);
    if (!of) return std::nullopt;
    const Int256 length = length_of(of->x);
    const int drop = bit_width(length) - 128;
    const Uint128 error = (Uint128{1} << 34) + (Uint128{1} << 5) + (of->error << 4) + 2;
    const FixedDigits digits{static_cast<Uint128>(shifted(length, drop)), unit + of->shift + drop - 125, error};
    const std::optional<double> rounded = digits.rounded();
    return rounded ? std::optional(at_least_subnormal(*rounded)) : std::nullopt;
}

// Returns |w x u| / |u|. |w x u| is cut to 127 digits before the division: a relative error of at most 2^-126.
std::optional<double> fixed_distance_from_line(const IntegerVector& w, const IntegerVector& u, int unit,
                                               bool is_exact) noexcept {
    const int error = is_exact ? 0 : 5;
    const auto line = leading(u, error), product = leading_product(w, u, error, error);
    if (!line || !product) return std::nullopt;
    const Int256 length = length_of(product->x);
    const int cut = bit_width(length) - 127;
    const Int256 quotient =
        multiply_halves(static_cast<Uint128>(shifted(length, cut)), inverse_root(square_of(line->x)));
    const int drop = bit_width(quotient) - 128;
    const int exponent = (unit + product->shift + cut - 125) + (drop - 252 - line->shift);
    const Uint128 off = (Uint128{1} << 35) + (Uint128{1} << 6) + ((product->error + line->error) << 4) + 2;
    const std::optional<double> rounded =
        FixedDigits{static_cast<Uint128>(shifted(quotient, drop)), exponent, off}.rounded();
    return rounded ? std::optional(at_least_subnormal(*rounded)) : std::nullopt;
}

}  // namespace ecods::exact
