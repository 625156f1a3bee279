#include <gtest/gtest.h>

#include <sstream>

#include "ecods/predicates.hpp"

namespace ecods::names_test {
namespace {

TEST(Names, SignsAndRelationsPrint) {
    std::ostringstream out;
    out << Sign::negative << ' ' << Sign::zero << ' ' << Sign::positive << ' ' << Relation::disjoint << ' '
        << Relation::touching << ' ' << Relation::crossing;
    EXPECT_EQ(out.str(), "negative zero positive disjoint touching crossing");
}

}  // namespace
}  // namespace ecods::names_test
