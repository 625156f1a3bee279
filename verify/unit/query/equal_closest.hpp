// Expects equal closest points, bit by bit.
#pragma once

#include <gtest/gtest.h>

#include "base/double_key.hpp"
#include "ecods/results.hpp"

namespace ecods {

inline bool are_equal(double x, double y) {
    return key_of(x) == key_of(y);
}
inline bool are_equal(const Vec3& x, const Vec3& y) {
    return are_equal(x[0], y[0]) && are_equal(x[1], y[1]) && are_equal(x[2], y[2]);
}
inline void expect_equal(const ClosestPoints& found, const ClosestPoints& expected) {
    EXPECT_TRUE(are_equal(found.distance, expected.distance)) << found.distance << ", " << expected.distance;
    EXPECT_EQ(found.kind, expected.kind);
    EXPECT_EQ(found.a, expected.a);
    EXPECT_EQ(found.b, expected.b);
    EXPECT_TRUE(are_equal(found.point_a, expected.point_a)) << found.point_a << "\n" << expected.point_a;
    EXPECT_TRUE(are_equal(found.point_b, expected.point_b)) << found.point_b << "\n" << expected.point_b;
}

}  // namespace ecods
