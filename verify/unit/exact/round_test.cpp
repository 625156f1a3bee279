// Roots and quotients of integers: the nearest double, half-way cases, powers of two and the ends of the range
// included, in every floating-point environment.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "exact/measure/round/squared_distance.hpp"
#include "measured_pairs.hpp"
#include "oracle/nearest.hpp"
#include "oracle_pair.hpp"

namespace ecods::exact::round_test {
namespace {

std::vector<std::uint64_t> limbs_of(const mpz_class& x) {
    if (x == 0) return {};
    std::vector<std::uint64_t> limbs((mpz_sizeinbase(x.get_mpz_t(), 2) + 63) / 64);
    mpz_export(limbs.data(), nullptr, -1, sizeof(std::uint64_t), 0, 0, x.get_mpz_t());
    return limbs;
}

SquaredDistance squared(const mpz_class& num, const mpz_class& den, int exponent) {
    SquaredDistance result;
    result.num.assign(limbs_of(num));
    result.den.assign(limbs_of(den));
    result.exponent = exponent;
    return result;
}

mpz_class random_integer(Random& random, std::uint32_t bit_count) {
    mpz_class x = 1;
    for (std::uint32_t i = 1; i < bit_count; i += 16) x = (x << 16) + random.below(65536);
    return x;
}

void check_root(const mpz_class& num, const mpz_class& den, int exponent) {
    const SquaredDistance square = squared(num, den, exponent);
    const oracle::ExactRoot root{num, den, exponent};
    const double expected = oracle::nearest(root);
    for (const int environment : environments) {
        const double d = in_environment(environment, [&] { return round_root(square); });
        ASSERT_EQ(bits(d), bits(expected)) << num << " / " << den << " 2^" << exponent;
        ASSERT_EQ(in_environment(environment, [&] { return compare(square, d); }), oracle::compare(root, d));
    }
}

void check_quotient(const mpz_class& num, const mpz_class& den, int exponent) {
    for (const bool negative : {false, true}) {
        const double expected = oracle::nearest(oracle::ExactFraction{negative ? mpz_class(-num) : num, den, exponent});
        for (const int environment : environments) {
            const double x = in_environment(
                environment, [&] { return round_quotient(limbs_of(num), limbs_of(den), exponent, negative); });
            ASSERT_EQ(bits(x), bits(expected)) << num << " / " << den << " 2^" << exponent;
        }
    }
}

// An odd number of 54 digits is half-way between two doubles; so is one with all ones, below a power of two.
mpz_class half_way(Random& random) {
    switch (random.below(4)) {
        case 0:
            return (mpz_class(1) << 54) - 1 - 2 * random.below(3);
        case 1:
            return (mpz_class(1) << 53) + 1 + 2 * random.below(3);
        default:
            return random_integer(random, 49) * 32 + 2 * random.below(16) + 1;
    }
}

int some_exponent(Random& random) {
    switch (random.below(4)) {
        case 0:
            return static_cast<int>(random.below(60)) - 1140;  // subnormal, and too small
        case 1:
            return static_cast<int>(random.below(30)) + 955;  // the largest, and too large
        default:
            return static_cast<int>(random.below(200)) - 100;
    }
}

TEST(Round, RootsAtAndNextToHalfWayPoints) {
    Random random(19);
    for (int i = 0; i < 4000; ++i) {
        const mpz_class root = i % 5 == 0 ? mpz_class(mpz_class(1) << (50 + random.below(6))) : half_way(random);
        const mpz_class den = i % 3 == 0 ? mpz_class(1) : random_integer(random, 10 + random.below(900));
        const mpz_class num = root * root * den;
        const int exponent = some_exponent(random);
        check_root(num, den, exponent);
        check_root(num + 1, den, exponent);
        check_root(num - 1, den, exponent);
        // As near, relative to the number: more digits than any fixed number of leading ones.
        check_root((num << 300) + 1, den << 300, exponent);
        check_root((num << 300) - 1, den << 300, exponent);
        if (HasFatalFailure()) return;
    }
}

TEST(Round, RootsOfAnyWidths) {
    Random random(20);
    for (int i = 0; i < 4000; ++i) {
        const mpz_class num = random_integer(random, 1 + random.below(1500));
        const mpz_class den = random_integer(random, 1 + random.below(1000));
        const int width =
            static_cast<int>(mpz_sizeinbase(num.get_mpz_t(), 2)) - static_cast<int>(mpz_sizeinbase(den.get_mpz_t(), 2));
        check_root(num, den, some_exponent(random) - width / 2);
        if (HasFatalFailure()) return;
    }
    check_root(0, 7, 3);
    check_root(1, 1, -3000);
    check_root(1, 1, 3000);
}

// Limbs of ones and of zeros, where a digit of a quotient is guessed too large.
TEST(Round, QuotientsThatAreHardToDivide) {
    Random random(21);
    const auto hard = [&](std::uint32_t limb_count) {
        mpz_class x = 0;
        for (std::uint32_t i = 0; i < limb_count; ++i) {
            const std::uint32_t kind = random.below(5);
            const mpz_class ones = (mpz_class(1) << 64) - 1;
            const mpz_class limb = kind == 0   ? mpz_class(0)
                                   : kind == 1 ? ones
                                   : kind == 2 ? mpz_class(mpz_class(1) << 63)
                                   : kind == 3 ? mpz_class(ones - random.below(3))
                                               : random_integer(random, 64) % (ones + 1);
            x = (x << 64) + limb;
        }
        return x == 0 ? mpz_class(1) : x;
    };
    for (int i = 0; i < 20000; ++i) {
        const mpz_class num = hard(1 + random.below(8)), den = hard(1 + random.below(6));
        check_quotient(num, den, -60);
        check_root(num, den, 0);
        if (HasFatalFailure()) return;
    }
    // What remains after the first digit has the divisor's leading limb: the second one is guessed as large as can be,
    // and is less by one or two.
    for (int i = 0; i < 1000; ++i) {
        const mpz_class top = mpz_class(1) << 127, limb = mpz_class(1) << 64;
        const mpz_class den = top + limb - 1 - random.below(3), rest = top + random.below(5);
        const mpz_class digit = (mpz_class(1) << 55) + random.below(1000);
        check_root(den * digit + rest, den, 0);
        if (HasFatalFailure()) return;
    }
}

TEST(Round, QuotientsAtAndNextToHalfWayPoints) {
    Random random(22);
    for (int i = 0; i < 4000; ++i) {
        const mpz_class den = i % 3 == 0 ? mpz_class(1) : random_integer(random, 10 + random.below(900));
        const mpz_class num = half_way(random) * den;
        const int exponent = some_exponent(random);
        check_quotient(num, den, exponent);
        check_quotient(num + 1, den, exponent);
        check_quotient(num - 1, den, exponent);
        check_quotient((num << 300) + 1, den << 300, exponent);
        check_quotient((num << 300) - 1, den << 300, exponent);
        if (HasFatalFailure()) return;
    }
    check_quotient(0, 3, 5);
}

}  // namespace
}  // namespace ecods::exact::round_test
