#include "ecods/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ecods/error.hpp"
#include "geometry/same_bits.hpp"

namespace ecods::pose_test {
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
                } catch (const InvalidArgument& error) {
                    const std::string r = std::to_string(row), c = std::to_string(column);
                    EXPECT_EQ(error.argument, Argument::pose);
                    EXPECT_EQ(error.part, column == 3 ? "t(" + r + ")" : "R(" + r + ", " + c + ")");
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

TEST(Pose, SameBitsComparesEachEntry) {
    const Pose pose = Pose::from_quaternion(Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5), Vec3(1, 2, 3));
    for (int k = 0; k < 12; ++k) {
        Pose other = pose;
        double& entry = k < 9 ? other.R.data()[k] : other.t[k - 9];
        entry = std::nextafter(entry, 10);
        EXPECT_FALSE(same_bits(pose, other)) << k;
    }
    EXPECT_TRUE(same_bits(pose, Pose(pose)));
}

TEST(Pose, IsMadeOfWhatOthersHave) {
    const Eigen::Quaterniond q(0.5, -0.5, 0.5, 0.5);
    const Vec3 t(1, -2, 3);
    const Pose turned = Pose::from_quaternion(q, t);
    EXPECT_EQ(turned.R, q.toRotationMatrix());
    EXPECT_EQ(turned.t, t);
    // Taken as given.
    const Eigen::Quaterniond twice(1, 1, 0, 0);
    EXPECT_EQ(Pose::from_quaternion(twice, t).R, (Mat3() << 1, 0, 0, 0, -1, -2, 0, 2, -1).finished());

    Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
    isometry.linear() = turned.R;
    isometry.translation() = t;
    EXPECT_EQ(Pose::from_isometry(isometry), turned);
    EXPECT_EQ(Pose::from_matrix(isometry.matrix()), turned);
}

TEST(Pose, TheLastRowOfAMatrixIsChecked) {
    const double tiny = std::numeric_limits<double>::denorm_min(), nan = std::numeric_limits<double>::quiet_NaN();
    for (int column = 0; column < 4; ++column) {
        const double right = column == 3 ? 1 : 0;
        for (const double bad : {right + 1, std::nextafter(right, 2), right == 0 ? -tiny : -1.0, nan}) {
            Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
            matrix(3, column) = bad;
            try {
                Pose::from_matrix(matrix);
                FAIL() << column << " " << bad;
            } catch (const InvalidArgument& error) {
                EXPECT_EQ(error.argument, Argument::pose);
                EXPECT_EQ(error.part, "(3, " + std::to_string(column) + ")");
                EXPECT_NE(std::string(error.what()).find(error.part), std::string::npos);
            }
        }
    }
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix(3, 1) = -0.0;
    EXPECT_EQ(Pose::from_matrix(matrix), Pose());
}

}  // namespace
}  // namespace ecods::pose_test
