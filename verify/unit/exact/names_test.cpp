#include <gtest/gtest.h>

#include <sstream>

#include "ecods/primitives.hpp"

namespace ecods::names_test {
namespace {

TEST(Names, SignsAndRelationsPrint) {
    std::ostringstream out;
    out << Sign::negative << ' ' << Sign::zero << ' ' << Sign::positive << ' ' << Relation::apart << ' '
        << Relation::touching << ' ' << Relation::crossing;
    EXPECT_EQ(out.str(), "negative zero positive apart touching crossing");
}

}  // namespace
}  // namespace ecods::names_test
