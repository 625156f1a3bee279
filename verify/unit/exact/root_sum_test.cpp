// Exact sums of doubles, and sums of a fraction and a root, against GMP's rational numbers.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "exact/measure/round/round_root_sum.hpp"
#include "exact/number/exact_sum.hpp"
#include "oracle/rounded.hpp"

namespace ecods::exact {
namespace {

std::mt19937_64 generator(11);

std::uint64_t below(std::uint64_t count) {
    return generator() % count;
}

mpz_class to_mpz(const Integer& x) {
    mpz_class result = 0;
    const NaturalSpan limbs = x.limbs();
    for (std::size_t i = limbs.size(); i-- > 0;) result = (result << 64) + static_cast<unsigned long>(limbs[i]);
    return x.sign() < 0 ? mpz_class(-result) : result;
}
Integer to_integer(mpz_class x) {
    const bool is_negative = sgn(x) < 0;
    x = abs(x);
    std::vector<std::uint64_t> limbs;
    for (; sgn(x) != 0; x >>= 64) limbs.push_back(mpz_class(x & mpz_class(~0UL)).get_ui());
    return {NaturalSpan(limbs), is_negative};
}
mpz_class any_integer(std::uint64_t bits_max) {
    mpz_class x = 1;
    for (std::uint64_t bits = below(bits_max); bits > 0; --bits) x = 2 * x + (below(2) == 0 ? 0 : 1);
    return x;
}
mpq_class times_power(const mpz_class& x, int e) {
    return e >= 0 ? mpq_class(x << static_cast<unsigned>(e))
                  : mpq_class(x) / mpq_class(mpz_class(1) << static_cast<unsigned>(-e));
}

oracle::FractionAndRoot truth_of(const RootSum& sum) {
    mpq_class square = times_power(to_mpz(sum.y), 2 * sum.f) / mpq_class(to_mpz(sum.w));
    mpq_class fraction = times_power(to_mpz(sum.x), sum.e) / mpq_class(to_mpz(sum.z));
    return {fraction, sum.is_subtracted ? -1 : 1, square};
}

void expect_right(const RootSum& sum) {
    const oracle::FractionAndRoot truth = truth_of(sum);
    const double got = round_root_sum(sum), expected = oracle::nearest(truth);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(expected)) << got << ", " << expected;
    EXPECT_EQ(sign(sum), (truth.sign() > 0) - (truth.sign() < 0));
}

RootSum made_of(const mpz_class& x, const mpz_class& z, int e, const mpz_class& y, const mpz_class& w, int f,
                bool is_subtracted) {
    RootSum sum;
    sum.x = to_integer(x);
    sum.z = to_integer(z);
    sum.e = e;
    sum.y = to_integer(y);
    sum.w = to_integer(w);
    sum.f = f;
    sum.is_subtracted = is_subtracted;
    return sum;
}

TEST(RootSum, AnyNumbers) {
    for (int i = 0; i < 3000; ++i) {
        const std::uint64_t bits = i % 3 == 0 ? 900 : 80;
        const mpz_class x = below(8) == 0 ? mpz_class(0) : any_integer(bits),
                        y = below(8) == 0 ? mpz_class(0) : any_integer(bits);
        const int e = static_cast<int>(below(80)) - 40, f = static_cast<int>(below(80)) - 40;
        expect_right(
            made_of(below(2) == 0 ? x : mpz_class(-x), any_integer(bits), e, y, any_integer(bits), f, below(2) == 0));
    }
}

// The root of y / w is near x / z: y = (x / z)^2 w 4^(e - f) up to the last bits.
TEST(RootSum, NumbersThatCancel) {
    for (int i = 0; i < 3000; ++i) {
        const mpz_class z = any_integer(60), w = any_integer(200);
        const mpz_class x = any_integer(200) + 1;
        const unsigned up = 2 * static_cast<unsigned>(below(100));
        mpz_class y = ((x * x * w) << up) / (z * z);
        y += static_cast<long>(below(5)) - 2;
        if (sgn(y) < 0) continue;
        const int e = static_cast<int>(below(2000)) - 1000;
        expect_right(made_of(x, z, e, y, w, e - static_cast<int>(up / 2), true));
        expect_right(made_of(-x, z, e, y, w, e - static_cast<int>(up / 2), false));
    }
}

// A rational root, which makes the sum the middle of two doubles, or next to it.
TEST(RootSum, HalfWayCases) {
    for (int i = 0; i < 3000; ++i) {
        const mpz_class root = any_integer(120), w = any_integer(60);
        const int unit = i % 4 == 0 ? -1075 : static_cast<int>(below(1800)) - 1000;
        const mpz_class middle = i % 4 == 0 ? any_integer(8) : (mpz_class(1) << 53) + any_integer(53);
        // x + root / w = middle
        const mpz_class near = below(3) == 0 ? mpz_class(static_cast<long>(below(3)) - 1) : mpz_class(0);
        const mpz_class x = middle * w - root + near;
        const int sign = below(2) == 0 ? 1 : -1;
        expect_right(made_of(sign * x, w, unit, root * root, w * w, unit, sign < 0));
    }
}

TEST(RootSum, TheEndsOfTheRange) {
    const mpz_class one = 1;
    for (const int e : {-1080, -1076, -1075, -1074, 1022, 1023, 1024, 4000, -4000}) {
        for (const int x : {0, 1, 2, 3}) {
            for (const bool is_subtracted : {false, true}) {
                expect_right(made_of(x, one, e, 2, one, e, is_subtracted));
                expect_right(made_of(x, one, e, 4, one, e, is_subtracted));
                expect_right(made_of(-x, 3, e, 1, 9, e, is_subtracted));
                expect_right(made_of(x, one, e, 2, one, -e, is_subtracted));
            }
        }
    }
    // Half a unit above the largest double.
    const mpz_class largest = (mpz_class(1) << 54) - 1;
    expect_right(made_of(largest, one, 970, 0, one, 0, false));
    expect_right(made_of(largest, one, 970, 1, one, -4000, true));
}

double any_double() {
    const std::uint64_t exponent = below(4) == 0 ? below(2047) : 1000 + below(60);
    return std::bit_cast<double>(exponent << 52 | (generator() & 0xfffffffffffff & ~std::uint64_t{0} << below(53)));
}

TEST(ExactSum, BoundsAreTheNearestDoubles) {
    for (int i = 0; i < 20000; ++i) {
        ExactSum sum;
        mpq_class truth = 0;
        const std::uint64_t count = below(5);
        for (std::uint64_t k = 0; k < count; ++k) {
            const double x = any_double() * (below(3) == 0 ? -1 : 1);
            truth += mpq_class(x);
            sum = sum.plus(x);
        }
        EXPECT_EQ(sum.sign(), sgn(truth));
        const ScaledInteger scaled = sum.scaled();
        EXPECT_EQ(times_power(to_mpz(scaled.m()), scaled.e()), truth);
        constexpr double infinity = std::numeric_limits<double>::infinity();
        EXPECT_TRUE(sum.lower() == -infinity || mpq_class(sum.lower()) <= truth);
        EXPECT_TRUE(sum.upper() == infinity || mpq_class(sum.upper()) >= truth);
        if (sum.is_double()) {
            EXPECT_EQ(sum.lower(), sum.upper());
        } else {
            EXPECT_EQ(sum.upper(), std::nextafter(sum.lower(), infinity));
        }
        const ExactSum negative = -sum;
        EXPECT_EQ(negative.lower(), -sum.upper());
        EXPECT_EQ(negative.upper(), -sum.lower());
        EXPECT_EQ(negative.sign(), -sum.sign());
        const Limit at_most{sum}, below_it{sum, true};
        if (sum.sign() <= 0) continue;
        EXPECT_EQ(at_most.greatest(), sum.lower());
        EXPECT_EQ(below_it.greatest(), sum.is_double() ? std::nextafter(sum.lower(), -1) : sum.lower());
    }
}

TEST(ExactSum, OfNumbersFarApart) {
    const ExactSum sum = ExactSum(0x1p1000).plus(0x1p-1074).plus(-0x1p1000).plus(0x1p-1074);
    EXPECT_EQ(sum.lower(), 0x1p-1073);
    EXPECT_TRUE(sum.is_double());
    const ExactSum beyond = ExactSum(0x1p1023).plus(0x1p1023);
    EXPECT_EQ(beyond.lower(), std::numeric_limits<double>::max());
    EXPECT_EQ(beyond.upper(), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(beyond.is_double());
    EXPECT_EQ(ExactSum(1).plus(0x1p-60).lower(), 1);
    EXPECT_EQ(ExactSum(1).minus(0x1p-60).upper(), 1);
    EXPECT_EQ(ExactSum(0).plus(-0.0).sign(), 0);
}

mpf_class in_digits(const RootSum& sum) {
    const oracle::FractionAndRoot truth = truth_of(sum);
    const mpf_class root = sqrt(mpf_class(truth.square, 4000));
    return mpf_class(mpf_class(truth.fraction, 4000) + (sum.is_subtracted ? -root : root), 4000);
}

// By 4000 digits: two such numbers are equal if they differ by less than 2^-3000.
int sign_of(const mpf_class& difference) {
    mpf_class least(1, 4000);
    mpf_div_2exp(least.get_mpf_t(), least.get_mpf_t(), 3000);
    return abs(difference) < least ? 0 : sgn(difference);
}
void expect_compared(const RootSum& a, const RootSum& b) {
    const int expected = sign_of(in_digits(a) - in_digits(b));
    EXPECT_EQ(compare(a, b), expected);
    EXPECT_EQ(compare(b, a), -expected);
}

TEST(RootSum, Compared) {
    const auto any = [&] {
        const auto small = [&] { return below(3) == 0 ? mpz_class(0) : any_integer(4); };
        const mpz_class x = below(2) == 0 ? small() : any_integer(60);
        const int e = static_cast<int>(below(6)) - 3, f = static_cast<int>(below(6)) - 3;
        return made_of(below(2) == 0 ? x : mpz_class(-x), any_integer(30), e, small(), any_integer(6), f,
                       below(2) == 0);
    };
    for (int i = 0; i < 3000; ++i) {
        const RootSum a = any();
        expect_compared(a, any());
        // The same number in other terms, and one that differs in one digit.
        const mpz_class k = any_integer(9);
        RootSum same = made_of(to_mpz(a.x) * k, to_mpz(a.z) * k, a.e, to_mpz(a.y) * k * k * 4, to_mpz(a.w) * k * k,
                               a.f - 1, a.is_subtracted);
        expect_compared(a, same);
        EXPECT_EQ(compare(a, same), 0);
        same.x = same.x + Integer(std::int64_t{1});
        expect_compared(a, same);
        expect_compared(a, affine(ScaledInteger(-0.5), same, ScaledInteger(0x1p-30)));
        const double rounded = round_root_sum(a);
        EXPECT_EQ(compare(a, ScaledInteger(rounded)),
                  sign_of(in_digits(a) - mpf_class(oracle::exactly(rounded), 4000)));
    }
}

}  // namespace
}  // namespace ecods::exact
