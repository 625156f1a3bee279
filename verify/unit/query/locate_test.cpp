#include "ecods/solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ecods/error.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

TEST(Locate, CubeWithFeatures) {
    const Soup soup = soup_of_box({-1, -1, -1}, {1, 1, 1});
    const Solid cube(soup.mesh());
    QueryMemory memory;
    for (const Pose& pose : common_poses()) {
        if (pose.R.cwiseAbs().maxCoeff() != 1 || pose.t != Vec3::Zero()) continue;
        for (int x = -3; x <= 3; ++x) {
            for (int y = -3; y <= 3; ++y) {
                for (int z = -3; z <= 3; ++z) {
                    const Vec3 half(x, y, z);
                    const int largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
                    const Location found = locate(0.5 * half, {cube, pose}, memory);
                    ASSERT_EQ(found.side, largest > 2 ? Side::outside : largest == 2 ? Side::on : Side::inside);
                    if (largest != 2) continue;
                    const int count = (std::abs(x) == 2) + (std::abs(y) == 2) + (std::abs(z) == 2);
                    if (count == 2) {
                        EXPECT_EQ(found.feature.kind, Feature::Kind::edge);
                    }
                    if (count == 3) {
                        EXPECT_EQ(found.feature.kind, Feature::Kind::vertex);
                        const Triangle& named = soup.triangles[found.feature.triangle];
                        EXPECT_EQ(soup.vertices[named[found.feature.corner]], Vec3(0.5 * half));
                        for (std::size_t i = 0; i < found.feature.triangle; ++i) {
                            for (const std::uint32_t corner : soup.triangles[i]) {
                                EXPECT_NE(soup.vertices[corner], Vec3(0.5 * half)) << "the least triangle";
                            }
                        }
                    }
                }
            }
        }
    }
}

TEST(Locate, PointsMustBeFinite) {
    const Solid cube(box({-1, -1, -1}, {1, 1, 1}));
    QueryMemory memory;
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 point = Vec3::Zero();
            point[axis] = bad;
            try {
                static_cast<void>(locate(point, {cube, {}}, memory));
                FAIL();
            } catch (const InvalidArgument& error) {
                EXPECT_EQ(error.argument, Argument::point);
                EXPECT_EQ(error.part, "(" + std::to_string(axis) + ")");
            }
        }
    }
}

TEST(Locate, SubnormalsAndFarPoints) {
    const Solid cube(box({-1, -1, -1}, {1, 1, 1}));
    QueryMemory memory;
    const double tiny = 0x1p-1074, huge = 1e308;
    const Pose identity;
    EXPECT_EQ(locate({1, tiny, 0}, {cube, identity}, memory).side, Side::on);
    EXPECT_EQ(locate({tiny, tiny, tiny}, {cube, identity}, memory).side, Side::inside);
    EXPECT_EQ(locate({huge, huge, -huge}, {cube, identity}, memory).side, Side::outside);
    Pose small;
    small.R *= tiny;
    EXPECT_EQ(locate({0, 0, 0}, {cube, small}, memory).side, Side::inside);
    EXPECT_EQ(locate({tiny, 0, 0}, {cube, small}, memory).side, Side::on);
    EXPECT_EQ(locate({2 * tiny, 0, 0}, {cube, small}, memory).side, Side::outside);
    Pose large;
    large.R *= huge;
    EXPECT_EQ(locate({huge, 1, 1}, {cube, large}, memory).side, Side::on);
    EXPECT_EQ(locate({std::nextafter(huge, 0.0), 1, 1}, {cube, large}, memory).side, Side::inside);
}

}  // namespace
}  // namespace ecods
