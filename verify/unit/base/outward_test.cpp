#include "base/outward.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "base/hash.hpp"
#include "base/next.hpp"
#include "environment/instruction_sets.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

using environment::InstructionSetLimit;
using environment::supported_instruction_sets;

// All that follows is decided in integers: the order of doubles is that of their keys, and there are 2^29 doubles from
// a float to the next one.
constexpr std::int64_t doubles_per_float = std::int64_t{1} << 29;

bool is_float(double x) {
    return (std::bit_cast<std::uint64_t>(x) & (doubles_per_float - 1)) == 0;
}

bool is_tight_above(double rounded, double x) {
    const std::int64_t gap = key_of(rounded) - key_of(x);
    return is_float(rounded) && gap >= 0 && gap < doubles_per_float;
}

bool is_tight_below(double rounded, double x) {
    return is_tight_above(-rounded, -x);
}

bool is_nearest(double rounded, double x) {
    const std::int64_t gap = std::abs(key_of(rounded) - key_of(x));
    const bool is_even = (std::bit_cast<std::uint64_t>(rounded) & doubles_per_float) == 0;
    return is_float(rounded) && (gap < doubles_per_float / 2 || (gap == doubles_per_float / 2 && is_even));
}

TEST(Outward, RoundsOutwardsInEveryRoundingMode) {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        for (const double magnitude : {0.0, 0x1p-1074, 1e-40, 0x1p-126, 0.1, 1.0, 1 + 0x1p-30, 3e38, 1e300}) {
            for (const double x : {magnitude, -magnitude}) {
                std::fesetround(mode);
                volatile double input = x;
                const float up = round_up(input), down = round_down(input);
                std::fesetround(FE_TONEAREST);
                EXPECT_GE(static_cast<double>(up), x);
                EXPECT_LE(static_cast<double>(down), x);
                EXPECT_FALSE(std::fpclassify(up) == FP_SUBNORMAL || std::fpclassify(down) == FP_SUBNORMAL);
                if (std::abs(x) > 1e-30 && std::abs(x) < 1e38) {
                    EXPECT_LE(up - down, 0x1p-22 * std::abs(x));
                }
            }
        }
    }
}

// Around floats of every exponent, and half-way between them.
TEST(Outward, IsTightBesideEveryPowerOfTwo) {
    for (std::uint32_t exponent = 1; exponent < 255; ++exponent) {
        for (const std::uint32_t fraction : {0u, 1u, 0x3fffffu, 0x7ffffeu, 0x7fffffu}) {
            const auto at = static_cast<double>(std::bit_cast<float>(exponent << 23 | fraction));
            const double half_way = double_of(key_of(at) + doubles_per_float / 2);
            for (const double near : {at, half_way}) {
                for (const double x : {next_down(near), near, next_up(near)}) {
                    if (x < static_cast<double>(float_min) ||
                        x > static_cast<double>(std::numeric_limits<float>::max()))
                        continue;
                    EXPECT_TRUE(is_tight_above(static_cast<double>(round_up(x)), x)) << x;
                    EXPECT_TRUE(is_tight_below(static_cast<double>(round_down(x)), x)) << x;
                    EXPECT_TRUE(is_tight_above(static_cast<double>(round_up(-x)), -x)) << x;
                    EXPECT_TRUE(is_tight_below(static_cast<double>(round_down(-x)), -x)) << x;
                    EXPECT_EQ(round_to_nearest(-x), -round_to_nearest(x));
                    EXPECT_EQ(round_to_nearest(x), static_cast<float>(x)) << x;
                }
            }
        }
    }
}

TEST(Outward, EndsAreZeroTheLeastNormalOneAndInfinity) {
    constexpr double infinity = std::numeric_limits<double>::infinity(), tiny = 0x1p-1074;
    constexpr float float_infinity = std::numeric_limits<float>::infinity(), max = std::numeric_limits<float>::max();
    for (const double zero : {0.0, -0.0}) {
        for (const float rounded : {round_up(zero), round_down(zero), round_to_nearest(zero)}) {
            EXPECT_EQ(std::bit_cast<std::uint32_t>(rounded), 0U);
        }
    }
    EXPECT_EQ(round_up(tiny), float_min);
    EXPECT_EQ(round_down(tiny), 0);
    EXPECT_EQ(round_up(-tiny), 0);
    EXPECT_EQ(round_down(-tiny), -float_min);
    EXPECT_EQ(round_to_nearest(next_down(static_cast<double>(float_min))), 0);
    EXPECT_EQ(round_up(next_up(static_cast<double>(max))), float_infinity);
    EXPECT_EQ(round_down(next_up(static_cast<double>(max))), max);
    EXPECT_EQ(round_up(-1e300), -max);
    EXPECT_EQ(round_down(-1e300), -float_infinity);
    EXPECT_EQ(round_to_nearest(1e300), float_infinity);
    EXPECT_EQ(round_down(infinity), float_infinity);
    EXPECT_EQ(round_up(-infinity), -float_infinity);
}

// Eight and six roundings in straight lines, and their results used as doubles: what g++ 12 turns into vectors, without
// the rounding if it is a conversion.
struct Ends {
    double low[4], high[4];
};
struct Box {
    double low[3], high[3];
};

template <auto low_of, auto high_of>
ECODS_ALWAYS_INLINE void round_eight(Ends& ends, const double* c, const double* h) {
    ends = {{low_of(c[0] - h[0]), low_of(c[1] - h[1]), low_of(c[2] - h[2]), low_of(c[3] - h[3])},
            {high_of(c[0] + h[0]), high_of(c[1] + h[1]), high_of(c[2] + h[2]), high_of(c[3] + h[3])}};
}

template <auto low_of, auto high_of>
ECODS_ALWAYS_INLINE void round_six(Box& box, const double* c, const double* h) {
    box = {{low_of(c[0] - h[0]), low_of(c[1] - h[1]), low_of(c[2] - h[2])},
           {high_of(c[0] + h[0]), high_of(c[1] + h[1]), high_of(c[2] + h[2])}};
}

ECODS_ALWAYS_INLINE double up(double x) {
    return static_cast<double>(round_up(x));
}
ECODS_ALWAYS_INLINE double down(double x) {
    return static_cast<double>(round_down(x));
}
ECODS_ALWAYS_INLINE double nearest(double x) {
    return static_cast<double>(round_to_nearest(x));
}

// Calls check(c, h) with many coordinates, four of each, between 1/2 and 1 and between 1/8 and 1/4.
template <class Check>
void for_many_boxes(Check&& check) {
    std::uint64_t digest = 1;
    const auto fraction = [&] {
        digest = mix(digest + 1);
        return std::bit_cast<double>(0x3fe0000000000000u | digest >> 12);
    };
    for (const InstructionSet set : supported_instruction_sets()) {
        const InstructionSetLimit limit(set);
        for (int round = 0; round < 2000; ++round) {
            double c[4], h[4];
            for (double& x : c) x = fraction();
            for (double& x : h) x = fraction() / 4;
            check(c, h);
        }
    }
}

TEST(Outward, NoRoundingIsDroppedFromStraightLines) {
    for_many_boxes([](const double* c, const double* h) {
        Ends ends;
        dispatch<round_eight<down, up>>(ends, c, h);
        for (int k = 0; k < 4; ++k) {
            ASSERT_TRUE(is_tight_below(ends.low[k], c[k] - h[k]));
            ASSERT_TRUE(is_tight_above(ends.high[k], c[k] + h[k]));
        }
        Box box;
        dispatch<round_six<down, up>>(box, c, h);
        for (int k = 0; k < 3; ++k) {
            ASSERT_TRUE(is_tight_below(box.low[k], c[k] - h[k]));
            ASSERT_TRUE(is_tight_above(box.high[k], c[k] + h[k]));
        }
    });
}

TEST(Outward, NoRoundingToNearestIsDroppedFromStraightLines) {
    for_many_boxes([](const double* c, const double* h) {
        Ends ends;
        dispatch<round_eight<nearest, nearest>>(ends, c, h);
        for (int k = 0; k < 4; ++k) {
            ASSERT_TRUE(is_nearest(ends.low[k], c[k] - h[k]));
            ASSERT_TRUE(is_nearest(ends.high[k], c[k] + h[k]));
        }
        Box box;
        dispatch<round_six<nearest, nearest>>(box, c, h);
        for (int k = 0; k < 3; ++k) {
            ASSERT_TRUE(is_nearest(box.low[k], c[k] - h[k]));
            ASSERT_TRUE(is_nearest(box.high[k], c[k] + h[k]));
        }
    });
}

}  // namespace
}  // namespace ecods
