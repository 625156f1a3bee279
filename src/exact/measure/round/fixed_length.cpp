// A vector is taken as its leading digits x: the largest coordinate has 126, and each is off by less than `error`. Then
// 2^125 <= |x| < 2^127, and |x| is off by less than the root of 3 times error, a part of 2^-124 error.
//
// Errors are counted in parts of the result, whose leading 128 digits are below 2^128: a part of 2^-94, as of
// inverse_root, is below 2^34 of their units, and a part of 2^-124 error below 16 error.
#include "exact/measure/round/fixed_length.hpp"

#include "exact/measure/round/fixed_digits.hpp"

namespace ecods::exact {
namespace {

struct Leading {
    IntegerVector x{};
    int shift = 0;  // the vector is x 2^shift
    Uint128 error = 0;
};

// Nothing of a zero, or where an error is beyond 2^60.
std::optional<Leading> leading(const IntegerVector& v, int error) noexcept {
    const int width = bit_width(largest(v));
    if (width == 0) return std::nullopt;
    const int up = 126 - width;
    if (error != 0 && up > 54) return std::nullopt;
    return Leading{{v[0] << up, v[1] << up, v[2] << up}, -up, static_cast<Uint128>(error) << up};
}

// The product of two vectors, of coordinates off by errors of their own.
std::optional<Leading> leading_product(const IntegerVector& w, const IntegerVector& u, int w_error,
                                       int u_error) noexcept {
    const WideVector product = cross(w, u);
    const int width = bit_width(product);
    if (width == 0) return std::nullopt;
    const int shift = width - 126;
    Leading result{shifted(product, shift), shift, shift > 0 ? Uint128{1} : 0};
    if (w_error != 0 || u_error != 0) {
        // Of two products: |w| u_error + |u| w_error + u_error w_error each.
        const Int256 one = multiply(static_cast<Int128>(largest(w)) + w_error, u_error) +
                           multiply(static_cast<Int128>(largest(u)), w_error);
        const Int256 both = one + one;
        if (bit_width(both) - shift > 58) return std::nullopt;
        result.error += static_cast<Uint128>(shifted(both, shift)) + 1;
    }
    return result;
}

// |x| 2^125, off by parts of 2^-94 and 2^-123: s / sqrt(s), of s without its last 127 digits.
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

// |w x u| / |u|. The length has 127 digits when it is divided, of which none more than a part of 2^-126 is cut off.
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
