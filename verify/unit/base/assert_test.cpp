// Assertions as builds for debugging have them, whatever this build is.
#undef NDEBUG
#include "base/assert.hpp"

#include <gtest/gtest.h>

namespace ecods {
namespace {

TEST(AssertDeathTest, EndsTheProgramAndNamesPlaceAndCondition) {
    const int two = 2;
    ECODS_ASSERT(two + two == 4);
    EXPECT_DEATH(ECODS_ASSERT(two + two == 5), "assert_test.cpp:[0-9]+:.*two \\+ two == 5");
}

}  // namespace
}  // namespace ecods
