#include "base/next.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

}  // namespace
}  // namespace ecods
