// Vectors between parallel features, and crossings of edges, in fixed precision: each interval has the rational number
// in it, of exact points and of points that are off, in each floating-point environment.
#include "exact/measure/round/fixed_shift.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <random>

#include "exact/measure/round/fixed_crossing.hpp"
#include "integers.hpp"
#include "measured_pairs.hpp"
#include "oracle_pair.hpp"

namespace ecods::exact::fixed_shift_test {
namespace {

using Numbers = std::mt19937_64;
using testing::mpz_of;

Int128 any_integer(Numbers& numbers, int bits) {
    if (bits == 0) return 0;
    const Uint128 all = Uint128{numbers()} << 64 | numbers();
    const auto size = static_cast<Int128>(all >> (128 - bits));
    return (numbers() & 1) != 0 ? -size : size;
}
IntegerVector any_vector(Numbers& numbers, int bits) {
    return {any_integer(numbers, bits), any_integer(numbers, bits), any_integer(numbers, bits)};
}
// Moves each coordinate by at most `error`.
IntegerVector moved(Numbers& numbers, IntegerVector v, std::uint64_t error) {
    for (Int128& x : v) x += static_cast<Int128>(numbers() % (2 * error + 1)) - static_cast<Int128>(error);
    return v;
}

RationalPoint to_rationals(const IntegerVector& v) {
    return {mpz_of(v[0]), mpz_of(v[1]), mpz_of(v[2])};
}
RationalPoint scaled(const RationalPoint& v, const mpq_class& s) {
    return {v[0] * s, v[1] * s, v[2] * s};
}
mpq_class mpq_of(Uint128 x) {
    mpz_class result = static_cast<unsigned long>(static_cast<std::uint64_t>(x >> 64));
    result = (result << 64) + static_cast<unsigned long>(static_cast<std::uint64_t>(x));
    return result;
}

// True if the interval has x in it.
bool has(const FixedNumber& number, const mpq_class& x) {
    return abs(mpq_class(mpz_of(number.value)) - x) <= mpq_of(number.error);
}
// True if the interval has a number with the square and the sign of x in it, in units of 2^-digits.
bool has_root(const FixedNumber& number, const mpq_class& square, int sign, int digits) {
    mpq_class scaled = square;
    mpz_mul_2exp(scaled.get_num_mpz_t(), scaled.get_num_mpz_t(), static_cast<mp_bitcnt_t>(2 * digits));
    scaled.canonicalize();
    const mpq_class value = mpq_class(mpz_of(number.value)) * (sign < 0 ? -1 : 1), error = mpq_of(number.error);
    const mpq_class low = value - error, high = value + error;
    return high >= 0 && high * high >= scaled && (low <= 0 || low * low <= scaled);
}

struct Count {
    int asked = 0, known = 0;
};

// Expects the shift along n, and n / |n|, which may be turned around.
void expect_shift(const std::optional<FixedShift>& found, const RationalPoint& shift, const RationalPoint& n,
                  Count& count) {
    ++count.asked;
    if (!found) return;
    ++count.known;
    const mpq_class square = dot(n, n), along = dot(n, shift);
    ASSERT_GT(square, 0);
    for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_TRUE(has((*found)[k], shift[k])) << k;
        ASSERT_TRUE(has_root(found->direction(k), n[k] * n[k] / square, sgn(n[k]), FixedVector::unit_digits)) << k;
    }
    ASSERT_TRUE(has_root(found->length(), along * along / square, sgn(along), 0));
}

// The error of points that a round has: 0, or some units.
std::uint64_t any_error(Numbers& numbers) {
    return std::array<std::uint64_t, 4>{0, 0, 5, 1000}[numbers() % 4];
}
int any_width(Numbers& numbers, std::uint64_t error) {
    return error == 0 ? static_cast<int>(1 + numbers() % 122) : static_cast<int>(60 + numbers() % 61);
}

TEST(FixedShift, HasTheVectorBetweenPlanes) {
    Numbers numbers(1);
    Count count;
    for (int i = 0; i < 5000; ++i) {
        const std::uint64_t error = any_error(numbers);
        const int width = any_width(numbers, error);
        IntegerVector u = any_vector(numbers, width), v = any_vector(numbers, width), w = any_vector(numbers, width);
        if (numbers() % 4 == 0) u[2] = v[2] = 0;
        if (numbers() % 4 == 0) u[0] = v[1] = 0;
        if (numbers() % 8 == 0) w = {w[0] >> (width / 2), w[1] >> (width / 2), w[2] >> (width / 2)};
        const RationalPoint n = cross(to_rationals(u), to_rationals(v));
        const mpq_class square = dot(n, n);
        if (square == 0) continue;
        const RationalPoint shift = scaled(n, dot(n, to_rationals(w)) / square);
        const IntegerVector x = moved(numbers, u, error), y = moved(numbers, v, error), z = moved(numbers, w, error);
        for (const int environment : environments) {
            expect_shift(in_environment(environment, [&] { return FixedShift::across_plane(x, y, z, error); }), shift,
                         n, count);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(count.known, 3 * count.asked / 4);
}

TEST(FixedShift, HasTheVectorFromAPointToAPointOrALine) {
    Numbers numbers(2);
    Count count;
    for (int i = 0; i < 20000; ++i) {
        const std::uint64_t error = any_error(numbers);
        const int width = any_width(numbers, error);
        IntegerVector u = any_vector(numbers, width), w = any_vector(numbers, width);
        if (numbers() % 4 == 0) u[0] = u[numbers() % 3] = 0;
        if (numbers() % 4 == 0) w[numbers() % 3] = 0;
        const RationalPoint of_w = to_rationals(w), of_u = to_rationals(u);
        if (dot(of_w, of_w) == 0) continue;
        const IntegerVector x = moved(numbers, u, error), z = moved(numbers, w, error);
        expect_shift(FixedShift::of_vector(z, error), of_w, of_w, count);
        if (HasFatalFailure()) return;
        if (dot(of_u, of_u) == 0) continue;
        const RationalPoint rest = of_w - scaled(of_u, dot(of_u, of_w) / dot(of_u, of_u));
        if (dot(rest, rest) == 0) continue;
        expect_shift(FixedShift::across_line(x, z, error), rest, rest, count);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(count.known, 3 * count.asked / 4);
}

// Exact points and an axis: the numbers are exact.
TEST(FixedShift, IsExactAlongAnAxis) {
    const auto found = FixedShift::across_plane({5, 0, 1}, {7, 0, -3}, {11, 13, 17}, 0);
    ASSERT_TRUE(found);
    EXPECT_TRUE((*found)[1].value == 13 && (*found)[1].error == 0);
    EXPECT_TRUE((*found)[0].value == 0 && (*found)[0].error == 0);
    EXPECT_EQ(found->length().error, 0U);
    EXPECT_FALSE(FixedShift::across_plane({5, 0, 1}, {10, 0, 2}, {11, 13, 17}, 0));
    EXPECT_FALSE(FixedShift::of_vector({}, 0));
}

TEST(FixedCrossing, HasTheParameterAndThePoint) {
    Numbers numbers(3);
    Count count;
    for (int i = 0; i < 40000; ++i) {
        const std::uint64_t error = any_error(numbers);
        const int width = any_width(numbers, error);
        std::array<Int128, 2> u, v, d;
        for (auto* vector : {&u, &v, &d}) *vector = {any_integer(numbers, width), any_integer(numbers, width)};
        if (numbers() % 4 == 0) u[numbers() % 2] = 0;
        if (numbers() % 4 == 0) v[numbers() % 2] = 0;
        if (numbers() % 16 == 0) v = {u[0] + any_integer(numbers, width / 2), u[1]};
        if (numbers() % 16 == 0) d = numbers() % 2 == 0 ? u : std::array<Int128, 2>{};
        const auto product = [](const std::array<Int128, 2>& x, const std::array<Int128, 2>& y) -> mpq_class {
            return mpz_class(mpz_of(x[0]) * mpz_of(y[1]) - mpz_of(x[1]) * mpz_of(y[0]));
        };
        const mpq_class den = product(u, v);
        if (den == 0) continue;
        const mpq_class s = product(d, v) / den;
        if (s < 0 || s > 1) continue;
        const auto off = [&](std::array<Int128, 2> x, std::uint64_t by) {
            for (Int128& k : x) k += static_cast<Int128>(numbers() % (2 * by + 1)) - static_cast<Int128>(by);
            return x;
        };
        const std::uint64_t of_d = numbers() % 3 == 0 ? std::uint64_t{1} << (numbers() % 40) : 0;
        const auto x = off(u, error), y = off(v, error), z = off(d, of_d);
        const std::array<FixedNumber, 2> way{FixedNumber{z[0], of_d}, FixedNumber{z[1], of_d}};
        const auto found = find_crossing(way, x, y, error);
        ++count.asked;
        if (!found) continue;
        ++count.known;
        mpq_class scaled = s;
        mpz_mul_2exp(scaled.get_num_mpz_t(), scaled.get_num_mpz_t(), FixedParameter::digits);
        scaled.canonicalize();
        ASSERT_TRUE(has({found->value, found->error}, scaled));
        for (std::size_t k = 0; k < 2; ++k) ASSERT_TRUE(has(found->times(x[k], error), mpz_of(u[k]) * s));
        for (const int environment : environments) {
            const auto other = in_environment(environment, [&] { return find_crossing(way, x, y, error); });
            // The last digits depend on the rounding mode; the interval has the number in it.
            ASSERT_TRUE(other && has({other->value, other->error}, scaled));
        }
    }
    EXPECT_GT(count.known, count.asked / 2);
}

}  // namespace
}  // namespace ecods::exact::fixed_shift_test
