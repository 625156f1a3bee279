// Roots and quotients of integers are rounded to the nearest double. Integer division computes the leading digits,
// rounded down, and one bit that is set if the rest is zero.
//
// The digits and this bit together determine the rounding to fewer digits, also at ties and powers of two. For a root,
// floor(sqrt(x)) = floor(sqrt(floor(x))), so its digits follow from the digits of its square.
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/outward.hpp"
#include "exact/measure/round/squared_distance.hpp"

namespace ecods::exact {
namespace {

// A Truncated is the number (digits + rest) 2^exponent, 0 <= rest < 1. is_exact is true if the rest is 0.
struct Truncated {
    std::uint64_t digits;
    int exponent;
    bool is_exact;
};

// A Quotient holds whole = floor(num * 2^shift / den), which must be below 2^128. is_exact is true if the quotient is
// an integer.
struct Quotient {
    Uint128 whole;
    bool is_exact;
};

// Subtracts digit * divisor from the dividend. If the digit is too large, by one or two, decreases it and adds the
// divisor back to the dividend.
void subtract_product(std::uint64_t* dividend, NaturalSpan divisor, std::uint64_t& digit) noexcept {
    std::uint64_t carry = 0, borrow = 0;
    const std::size_t n = divisor.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Uint128 p = Uint128{digit} * divisor[i] + carry;
        const Uint128 difference = Uint128{dividend[i]} - static_cast<std::uint64_t>(p) - borrow;
        dividend[i] = static_cast<std::uint64_t>(difference);
        carry = static_cast<std::uint64_t>(p >> 64);
        borrow = static_cast<std::uint64_t>(difference >> 64) & 1;
    }
    const Uint128 difference = Uint128{dividend[n]} - carry - borrow;
    dividend[n] = static_cast<std::uint64_t>(difference);
    bool is_negative = (difference >> 64) != 0;
    while (is_negative) {
        --digit;
        std::uint64_t up = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Uint128 sum = Uint128{dividend[i]} + divisor[i] + up;
            dividend[i] = static_cast<std::uint64_t>(sum);
            up = static_cast<std::uint64_t>(sum >> 64);
        }
        const Uint128 sum = Uint128{dividend[n]} + up;
        dividend[n] = static_cast<std::uint64_t>(sum);
        is_negative = (sum >> 64) == 0;
    }
}

// Sets to[i] to limb first + i of a * 2^shift, for all i; shift >= 0. The limbs are those that limb_of_shifted()
// returns.
void set_shifted(std::span<std::uint64_t> to, NaturalSpan a, int shift, std::size_t first) noexcept {
    const int bits = shift % 64;
    // A negative position wraps around to a number that is greater than all positions.
    std::size_t at = first - static_cast<std::size_t>(shift) / 64;
    std::uint64_t below = at - 1 < a.size() ? a[at - 1] : 0;
    for (std::uint64_t& limb : to) {
        const std::uint64_t here = at < a.size() ? a[at] : 0;
        limb = bits == 0 ? here : here << bits | below >> (64 - bits);
        below = here;
        ++at;
    }
}

// Returns num * 2^shift / den by long division with two digits of 64 bits (Knuth, The Art of Computer Programming,
// volume 2, 4.3.1, algorithm D). The quotient must be below 2^128.
Quotient divide(NaturalSpan num, int shift, NaturalSpan den) noexcept {
    // Normalizes the divisor: its leading limb has its top bit set, and it has at least two limbs.
    const std::size_t n = std::max<std::size_t>(den.size(), 2);
    ECODS_ASSERT(n <= divisor_limbs);
    const int up = static_cast<int>(64 * n) - bit_width(den);
    std::array<std::uint64_t, divisor_limbs> v;
    set_shifted({v.data(), n}, den, up, 0);
    const NaturalSpan divisor{v.data(), n};

    const int total = shift + up;
    std::array<std::uint64_t, divisor_limbs + 2> u;
    bool is_exact = true;
    const std::size_t dropped = total < 0 ? static_cast<std::size_t>(-total + 63) / 64 : 0;
    for (std::size_t i = 0; i < std::min(dropped, num.size()); ++i) {
        const int lost = -total - static_cast<int>(64 * i);  // number of dropped bits in this limb and above it
        is_exact &= (lost >= 64 ? num[i] : num[i] << (64 - lost)) == 0;
    }
    const int fill = total + static_cast<int>(64 * dropped);  // >= 0
    set_shifted({u.data(), n + 2}, num, fill, dropped);

    Uint128 whole = 0;
    for (std::size_t j = 2; j-- > 0;) {
        const Uint128 top = Uint128{u[j + n]} << 64 | u[j + n - 1];
        std::uint64_t digit = ~std::uint64_t{0};
        if (u[j + n] < v[n - 1]) {
            Uint128 q = top / v[n - 1], r = top % v[n - 1];
            while (q * v[n - 2] > (r << 64 | u[j + n - 2])) {
                --q;
                r += v[n - 1];
                if (r >> 64) break;
            }
            digit = static_cast<std::uint64_t>(q);
        }
        if (digit != 0) subtract_product(&u[j], divisor, digit);
        whole = whole << 64 | digit;
    }
    for (std::size_t i = 0; i < n; ++i) is_exact &= u[i] == 0;
    return {whole, is_exact};
}

// Returns the integer part of sqrt(x), for 2^116 <= x < 2^126. The floating-point root is a first guess, with a
// relative error of 2^-50 in any rounding mode. A Newton step squares that error, and steps of one correct the rest.
std::uint64_t floor_of_root(Uint128 x) noexcept {
    const double guess = std::sqrt(static_cast<double>(static_cast<std::int64_t>(x >> 64))) * 0x1p32;
    auto m = static_cast<std::uint64_t>(guess);
    m = static_cast<std::uint64_t>((m + x / m) >> 1);
    while (Uint128{m} * m > x) --m;
    while (Uint128{m + 1} * (m + 1) <= x) ++m;
    return m;
}

// Returns the bits of the double nearest to x, ties to even. x must have at least 55 digits. The result is bits and not
// a double, because the processor may take a subnormal double for zero.
std::uint64_t nearest(const Truncated& x) noexcept {
    constexpr int least = -1074;
    const int width = static_cast<int>(std::bit_width(x.digits));
    const int exponent = std::max(x.exponent + width - 53, least);
    if (exponent > 971) return double_infinity_magnitude;
    const int drop = exponent - x.exponent;
    ECODS_ASSERT(drop > 0);
    std::uint64_t kept = 0;
    if (drop <= 64) {
        const std::uint64_t lost = x.digits << (64 - drop), half = std::uint64_t{1} << 63;
        kept = drop == 64 ? 0 : x.digits >> drop;
        const bool is_tie = lost == half && x.is_exact;
        if (lost > half || (lost == half && !x.is_exact) || (is_tie && (kept & 1) != 0)) ++kept;
    }
    // A carry out of the digits increases the exponent, as it should, even to infinity.
    return (static_cast<std::uint64_t>(exponent - least) << 52) + kept;
}

// Returns the bits of the double nearest to sqrt(num / den) 2^exponent.
std::uint64_t root_bits(NaturalSpan num, NaturalSpan den, int exponent) noexcept {
    if (num.empty()) return 0;
    // The shift must be even, to be halved by the root. The quotient then has 118 to 121 bits, and its root 59 to 61.
    const int shift = (120 - (bit_width(num) - bit_width(den))) & ~1;
    const Quotient quotient = divide(num, shift, den);
    const std::uint64_t root = floor_of_root(quotient.whole);
    const bool is_exact = quotient.is_exact && Uint128{root} * root == quotient.whole;
    return nearest({root, exponent - shift / 2, is_exact});
}

}  // namespace

double round_root(NaturalSpan num, NaturalSpan den, int exponent) noexcept {
    return std::bit_cast<double>(num.empty() ? 0 : std::max<std::uint64_t>(root_bits(num, den, exponent), 1));
}

double round_root(const SquaredDistance& square) noexcept {
    return round_root(square.num.limbs(), square.den.limbs(), square.exponent);
}

double round_cosine(NaturalSpan num, NaturalSpan den, bool negative) noexcept {
    return with_sign(root_bits(num, den, 0), negative);
}

double round_quotient(NaturalSpan num, NaturalSpan den, int exponent, bool negative) noexcept {
    if (num.empty()) return 0;
    const int shift = 60 - (bit_width(num) - bit_width(den));
    const Quotient quotient = divide(num, shift, den);
    const std::uint64_t bits =
        nearest({static_cast<std::uint64_t>(quotient.whole), exponent - shift, quotient.is_exact});
    return with_sign(bits, negative);
}

LeadingDigits leading_digits(NaturalSpan num, NaturalSpan den) noexcept {
    if (num.empty()) return {};
    const int shift = 127 - (bit_width(num) - bit_width(den));
    const Quotient quotient = divide(num, shift, den);
    return {quotient.whole, -shift, quotient.is_exact};
}

double round_digits(const LeadingDigits& x) noexcept {
    if (x.digits == 0) return 0;
    const auto high = static_cast<std::uint64_t>(x.digits >> 64), low = static_cast<std::uint64_t>(x.digits);
    return with_sign(nearest({high, x.exponent + 64, x.is_exact && low == 0}), false);
}

double round_integer(const Int256& x, int exponent) noexcept {
    const bool is_negative = x.high < 0;
    const Int256 size = is_negative ? Int256{} - x : x;
    Uint128 high = static_cast<Uint128>(size.high), low = size.low;
    if (high == 0) {
        if (low == 0) return 0;
        high = low;
        low = 0;
        exponent -= 128;
    }
    // Shifts left until the leading bit is set.
    const int up = 128 - bit_width(high);
    if (up > 0) {
        high = high << up | low >> (128 - up);
        low <<= up;
    }
    const bool is_exact = static_cast<std::uint64_t>(high) == 0 && low == 0;
    return with_sign(nearest({static_cast<std::uint64_t>(high >> 64), exponent + 192 - up, is_exact}), is_negative);
}

}  // namespace ecods::exact
