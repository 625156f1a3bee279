#include "base/next.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "base/outward.hpp"

namespace ecods {
namespace {

TEST(Next, IsNextafter) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double x : {0.0, -0.0, 1.0, -1.0, 0.1, -1e300, std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::lowest(), std::numeric_limits<double>::min(),
                           std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::denorm_min()}) {
        EXPECT_EQ(next_up(x), std::nextafter(x, infinity)) << x;
        EXPECT_EQ(next_down(x), std::nextafter(x, -infinity)) << x;
    }
    EXPECT_EQ(next_up(infinity), infinity);
    EXPECT_EQ(next_down(-infinity), -infinity);
    EXPECT_EQ(next_down(infinity), std::numeric_limits<double>::max());
    EXPECT_EQ(next_up(-infinity), std::numeric_limits<double>::lowest());
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

}  // namespace
}  // namespace ecods
