#include "oracle/nearest.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "oracle/float_environment.hpp"

namespace ecods::oracle {
namespace {

constexpr std::uint64_t bits_of_infinity = 0x7ff0000000000000;

// mantissa * 2^exponent
struct Dyadic {
    mpz_class mantissa;
    long exponent = 0;
};

// Doubles from 0 on are ordered as their bits are, and so are neighbours neighbours.
Dyadic from_bits(std::uint64_t bits) {
    const std::uint64_t biased = bits >> 52, fraction = bits & 0xfffffffffffff;
    Dyadic x;
    x.mantissa = static_cast<unsigned long>(biased == 0 ? fraction : fraction | std::uint64_t{1} << 52);
    x.exponent = static_cast<long>(biased == 0 ? 1 : biased) - 1075;
    return x;
}

Dyadic halfway_above(std::uint64_t bits) {
    Dyadic x = from_bits(bits);
    x.mantissa = 2 * x.mantissa + 1;
    --x.exponent;
    return x;
}

// The sign of a less b * 2^shift.
int compare_shifted(const mpz_class& a, const mpz_class& b, long shift) {
    return shift >= 0 ? cmp(a, mpz_class(b << shift)) : cmp(mpz_class(a << -shift), b);
}

int compare(const ExactRoot& root, const Dyadic& x) {
    return compare_shifted(root.num, mpz_class(root.den * x.mantissa * x.mantissa), 2 * (x.exponent - root.unit));
}

// The size of the fraction.
int compare(const ExactFraction& fraction, const Dyadic& x) {
    return compare_shifted(abs(fraction.num), mpz_class(fraction.den * x.mantissa), x.exponent - fraction.unit);
}

// 1: the number belongs to a double above, -1: below, 0: this is the nearest.
template <class Number>
int direction(const Number& number, std::uint64_t bits) {
    const bool is_even = bits % 2 == 0;
    if (bits < bits_of_infinity) {
        const int above = compare(number, halfway_above(bits));
        if (above > 0 || (above == 0 && !is_even)) return 1;
    }
    if (bits > 0) {
        const int below = compare(number, halfway_above(bits - 1));
        if (below < 0 || (below == 0 && !is_even)) return -1;
    }
    return 0;
}

// A positive root is no zero.
int direction_of_root(const ExactRoot& root, std::uint64_t bits) {
    if (!root.is_zero() && bits <= 1) {
        const int direct = bits == 0 ? 1 : direction(root, bits);
        return direct < 0 ? 0 : direct;
    }
    return direction(root, bits);
}

// Near num / den * 2^unit, or the root of it: any error is made good by steps from there.
double guess(const mpz_class& num, const mpz_class& den, long unit, bool is_root) {
    long num_exponent = 0, den_exponent = 0;
    double x = mpz_get_d_2exp(&num_exponent, num.get_mpz_t()) / mpz_get_d_2exp(&den_exponent, den.get_mpz_t());
    long exponent = num_exponent - den_exponent;
    if (is_root) {
        if (exponent % 2 != 0) {
            x *= 2;
            --exponent;
        }
        x = std::sqrt(x);
        exponent /= 2;
    }
    exponent += unit;
    if (exponent > 1030) return std::numeric_limits<double>::infinity();
    return exponent < -1080 ? 0 : std::ldexp(x, static_cast<int>(exponent));
}

template <class Direction>
std::uint64_t walk_from(double start, const Direction& direction) {
    auto bits = std::bit_cast<std::uint64_t>(start);
    for (;;) {
        const int step = direction(bits);
        if (step == 0) return bits;
        bits = step > 0 ? bits + 1 : bits - 1;
    }
}

}  // namespace

int compare(const ExactRoot& root, double d) {
    return std::isinf(d) ? -1 : compare(root, from_bits(std::bit_cast<std::uint64_t>(std::abs(d))));
}

int compare(const ExactRoot& first, const ExactRoot& second) {
    return compare_shifted(first.num * second.den, mpz_class(second.num * first.den), 2 * (second.unit - first.unit));
}

bool is_nearest(const ExactRoot& root, double d) {
    return !std::signbit(d) && !std::isnan(d) && direction_of_root(root, std::bit_cast<std::uint64_t>(d)) == 0;
}

double nearest(const ExactRoot& root) {
    if (root.is_zero()) return 0;
    const FloatEnvironment environment;  // where subnormals are flushed, the guess would be far off
    return std::bit_cast<double>(walk_from(guess(root.num, root.den, root.unit, true),
                                           [&](std::uint64_t bits) { return direction_of_root(root, bits); }));
}

bool is_nearest(const ExactFraction& fraction, double d) {
    if (std::isnan(d)) return false;
    // A zero is +0, whatever it was rounded from.
    if (d == 0 ? std::signbit(d) : std::signbit(d) != (sgn(fraction.num) < 0)) return false;
    return direction(fraction, std::bit_cast<std::uint64_t>(std::abs(d))) == 0;
}

double nearest(const ExactFraction& fraction) {
    if (sgn(fraction.num) == 0) return 0;
    const FloatEnvironment environment;
    const std::uint64_t bits = walk_from(guess(abs(fraction.num), fraction.den, fraction.unit, false),
                                         [&](std::uint64_t at) { return direction(fraction, at); });
    const double size = std::bit_cast<double>(bits);
    return sgn(fraction.num) < 0 && size > 0 ? -size : size;
}

}  // namespace ecods::oracle
