#include "geometry/key_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ecods::key_box_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(KeyBox, KeysOrderAsTheDoublesDo) {
    constexpr double tiny = std::numeric_limits<double>::denorm_min();
    const std::vector<double> ascending = {-infinity, -1e308,    -1, -0x1p-1022, -tiny,   0,
                                           tiny,      0x1p-1022, 1,  1e308,      infinity};
    for (std::size_t i = 1; i < ascending.size(); ++i) EXPECT_LT(key_of(ascending[i - 1]), key_of(ascending[i])) << i;
}

TEST(KeyBox, BothZerosAreOnePlace) {
    EXPECT_EQ(key_of(-0.0), key_of(0.0));
}

TEST(KeyBox, NeighboursStayApart) {
    for (const double x : {0.0, 1.0, -1.0, 1e300, -1e-300}) {
        EXPECT_LT(key_of(x), key_of(std::nextafter(x, infinity)));
        EXPECT_GT(key_of(x), key_of(std::nextafter(x, -infinity)));
    }
}

TEST(KeyBox, EachAxisAloneSeparatesAndASharedPointDoesNot) {
    const Aabb unit{.min = Vec3(0, 0, 0), .max = Vec3(1, 1, 1)};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            Aabb other = unit;
            other.min[axis] += side;
            other.max[axis] += side;
            EXPECT_TRUE(overlap(key_box(unit), key_box(other))) << axis << " " << side;
            double& facing = side > 0 ? other.min[axis] : other.max[axis];
            facing = std::nextafter(facing, side * infinity);
            EXPECT_FALSE(overlap(key_box(unit), key_box(other))) << axis << " " << side;
            EXPECT_FALSE(overlap(key_box(other), key_box(unit))) << axis << " " << side;
        }
    }
}

}  // namespace
}  // namespace ecods::key_box_test
