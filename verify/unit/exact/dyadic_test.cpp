#include "exact/number/dyadic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ecods::exact::dyadic_test {
namespace {

TEST(Dyadic, DecodesEveryKindOfDouble) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, 0.1, -1e300, 1e-300, std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::lowest(), std::numeric_limits<double>::min(),
                           std::numeric_limits<double>::denorm_min(), -3 * std::numeric_limits<double>::denorm_min()}) {
        const Dyadic d = decode(x);
        EXPECT_EQ(std::ldexp(static_cast<double>(d.m), d.e), x);
        EXPECT_TRUE(d.m == 0 ? d.e == 0 : d.m % 2 != 0) << x;
    }
}

TEST(Dyadic, RangesOfDigits) {
    BitRange range;
    EXPECT_TRUE(range.empty());
    EXPECT_EQ(range.width(), 0);
    range.include(decode(0));
    EXPECT_TRUE(range.empty());
    range.include(decode(6));  // 3 * 2
    EXPECT_EQ(range.low, 1);
    EXPECT_EQ(range.high, 3);
    range.include(decode(-0.25));
    EXPECT_EQ(range.low, -2);
    EXPECT_EQ((range * range).low, -4);
    EXPECT_TRUE((range * BitRange{}).empty());
}

TEST(Dyadic, DifferencesAreExact) {
    const auto digits = [](double a, double b) { return subtract(decode(a), decode(b))->digits(); };
    EXPECT_TRUE(digits(0.1, 0.1).empty());
    // Far numbers, a short difference.
    const BitRange range = digits(1e12 + 0.5, 1e12);
    EXPECT_EQ(range.low, -1);
    EXPECT_EQ(range.high, 0);
    EXPECT_EQ(subtract(decode(3), decode(0.25))->at(-4), 44);
    EXPECT_EQ(subtract(decode(0.5), decode(1))->at(-1), -1);
    EXPECT_FALSE(subtract(decode(0x1p100), decode(0x1p-100)));
    EXPECT_TRUE(subtract(decode(0x1p125), decode(1)));
}

}  // namespace
}  // namespace ecods::exact::dyadic_test
