#include "ecods/pose.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "ecods/error.hpp"
#include "geometry/same_bits.hpp"

namespace ecods {
namespace {

TEST(Pose, AnyFinitePoseIsValid) {
    Pose pose;
    pose.R.setZero();
    pose.t = Vec3::Constant(std::numeric_limits<double>::max());
    pose.R(0, 1) = std::numeric_limits<double>::denorm_min();
    EXPECT_NO_THROW(validate(pose));
}

TEST(Pose, EveryEntryIsChecked) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                Pose pose;
                (column == 3 ? pose.t[row] : pose.R(row, column)) = bad;
                try {
                    validate(pose);
                    FAIL() << row << " " << column;
                } catch (const InvalidPose& error) {
                    EXPECT_EQ(error.row, row);
                    EXPECT_EQ(error.column, column);
                }
            }
        }
    }
}

TEST(Pose, SameBitsIsFinerThanEqual) {
    Pose a, b;
    b.t[1] = -0.0;
    EXPECT_TRUE(a == b);
    EXPECT_FALSE(same_bits(a, b));
    EXPECT_TRUE(same_bits(a, a));
    b = a;
    b.R(2, 1) = std::numeric_limits<double>::denorm_min();
    EXPECT_FALSE(same_bits(a, b));
}

}  // namespace
}  // namespace ecods
