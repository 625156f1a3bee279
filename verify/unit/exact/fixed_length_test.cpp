// Lengths and distances from lines in fixed precision beside fractions of integers, of exact points and of points off
// by some units.
#include "exact/measure/round/fixed_length.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <random>

#include "environment/float_mode.hpp"
#include "exact/measure/round/limb_vectors.hpp"
#include "exact/measure/round/squared_distance.hpp"

namespace ecods::exact::fixed_length_test {
namespace {

using Vector = IntegerVector;
using Numbers = std::mt19937_64;

LimbVector<2> limbs_of(const Vector& v) {
    std::array<Limbs<2>, 3> limbs;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto bits = static_cast<Uint128>(v[k]);
        limbs[k] = {static_cast<std::uint64_t>(bits), static_cast<std::uint64_t>(bits >> 64)};
    }
    return difference<2>(limbs, {});
}

SquaredDistance square_of_length(const Vector& w, int unit) {
    SquaredDistance result;
    const LimbVector<2> limbs = limbs_of(w);
    result.num.assign(dot<2, 2>(limbs, limbs).limbs);
    result.exponent = unit;
    return result;
}

SquaredDistance square_from_line(const Vector& w, const Vector& u, int unit) {
    SquaredDistance result;
    const LimbVector<2> line = limbs_of(u);
    const LimbVector<4> c = cross<2>(limbs_of(w), line);
    result.num.assign(dot<4, 4>(c, c).limbs);
    result.den.assign(dot<2, 2>(line, line).limbs);
    result.exponent = unit;
    return result;
}

Int128 random_integer(Numbers& numbers, int bits) {
    const Uint128 all = Uint128{numbers()} << 64 | numbers();
    const auto size = static_cast<Int128>(all >> (128 - bits));
    return (numbers() & 1) != 0 ? -size : size;
}

// Below 2^122: of any digits, and of few.
Vector random_vector(Numbers& numbers) {
    const int bits = static_cast<int>(1 + numbers() % 121);
    return {random_integer(numbers, bits), random_integer(numbers, bits), random_integer(numbers, bits)};
}

Vector off_by(const Vector& v, int units, Numbers& numbers) {
    Vector result = v;
    for (Int128& x : result) x += static_cast<Int128>(numbers() % (2 * units + 1)) - units;
    return result;
}

// Some nearly parallel: the point is near the line.
struct PointAndLine {
    Vector w, u;

    explicit PointAndLine(Numbers& numbers) : w(random_vector(numbers)), u(random_vector(numbers)) {
        if (numbers() % 3 != 0) return;
        const int bits = 1 + static_cast<int>(numbers() % 90);
        for (std::size_t k = 0; k < 3; ++k) w[k] = u[k] / 3 + random_integer(numbers, bits);
    }
};

bool is_zero(const Vector& v) {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

TEST(FixedLength, RoundsAsFractionsDo) {
    Numbers numbers(1);
    int certain = 0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        const Vector w = random_vector(numbers);
        const int unit = static_cast<int>(numbers() % 600) - 400;
        const environment::InFloatMode in(environment::float_modes[numbers() % 8]);
        const std::optional<double> length = fixed_length(w, unit, true);
        if (is_zero(w)) {
            EXPECT_FALSE(length);
        }
        if (!length) continue;
        ++certain;
        EXPECT_EQ(*length, round_root(square_of_length(w, unit)));
    }
    EXPECT_GT(certain, count * 98 / 100);
}

TEST(FixedLength, RoundsDistancesFromLinesAsFractionsDo) {
    Numbers numbers(2);
    int certain = 0, others = 0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        const PointAndLine at(numbers);
        const int unit = static_cast<int>(numbers() % 600) - 400;
        const environment::InFloatMode in(environment::float_modes[numbers() % 8]);
        const std::optional<double> distance = fixed_distance_from_line(at.w, at.u, unit, true);
        if (!distance) {
            ++others;
            continue;
        }
        ++certain;
        EXPECT_EQ(*distance, round_root(square_from_line(at.w, at.u, unit)));
    }
    EXPECT_GT(certain, count * 95 / 100) << others;
}

TEST(FixedLength, IsRightWhereItIsCertainOfPointsThatAreOff) {
    Numbers numbers(3);
    int certain = 0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        const PointAndLine at(numbers);
        const environment::InFloatMode in(environment::float_modes[numbers() % 8]);
        const Vector w = off_by(at.w, 4, numbers), u = off_by(at.u, 4, numbers);
        if (const auto length = fixed_length(w, -100, false)) {
            ++certain;
            EXPECT_EQ(*length, round_root(square_of_length(at.w, -100)));
        }
        if (const auto distance = fixed_distance_from_line(w, u, -100, false)) {
            ++certain;
            EXPECT_EQ(*distance, round_root(square_from_line(at.w, at.u, -100)));
        }
    }
    EXPECT_GT(certain, count / 2);
}

TEST(FixedLength, RoundsToAtLeastTheLeastDouble) {
    EXPECT_EQ(fixed_length({1, 0, 0}, -1074, true), 0x1p-1074);
    const auto least = fixed_length({3, 0, 0}, -1200, true);
    EXPECT_TRUE(!least || *least == 0x1p-1074);
    EXPECT_EQ(fixed_length({3, 4, 0}, 0, true), 5);
    EXPECT_EQ(fixed_distance_from_line({3, 4, 0}, {0, 7, 0}, 1, true), 6);
}

// A length half-way between two doubles is no matter of digits.
TEST(FixedLength, IsNotCertainOfTies) {
    const Int128 tie = (Int128{1} << 53) + 1;
    EXPECT_FALSE(fixed_length({tie, 0, 0}, 0, true));
}

}  // namespace
}  // namespace ecods::exact::fixed_length_test
