// Signs by the bound of each determinant's own products are those of integers, on points of every width that are nearly
// degenerate, or exactly.

#include "exact/sign/difference_signs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/random.hpp"

namespace ecods::exact::difference_signs_test {
namespace {

using scenes::Random;
using IntegerPoint = std::array<std::int64_t, 3>;

// Six integer points below 2^bits, of which many are in one plane, on one line, equal, or next to it.
std::array<IntegerPoint, 6> six_points(Random& random, int bits) {
    const double max = std::ldexp(1.0, bits - 3);
    const auto any = [&] {
        IntegerPoint p;
        for (auto& x : p) x = random.below(4) == 0 ? 0 : static_cast<std::int64_t>(random.uniform(-max, max));
        return p;
    };
    const IntegerPoint origin = any(), p = any(), q = any();
    std::array<IntegerPoint, 6> points;
    for (auto& point : points) {
        const auto i = static_cast<std::int64_t>(random.below(5)) - 2,
                   j = static_cast<std::int64_t>(random.below(3)) - 1;
        const bool is_off = random.below(4) == 0;
        for (std::size_t k = 0; k < 3; ++k) {
            point[k] = origin[k] + i * p[k] + j * q[k] + (is_off ? static_cast<std::int64_t>(random.below(3)) - 1 : 0);
        }
        if (random.below(8) == 0) point = any();
    }
    return points;
}

TEST(DifferenceSigns, AreThoseOfIntegers) {
    Random random(81);
    int integer_count = 0;
    for (int i = 0; i < 60000; ++i) {
        const int bits = 3 + i % 47;
        const int low = static_cast<int>(random.below(400)) - 300;
        const IntegerPoints<OneLimbKernel, 6> integers{six_points(random, bits)};
        Points<6> points;
        for (std::size_t p = 0; p < 6; ++p) {
            for (std::size_t k = 0; k < 3; ++k) {
                points[p][k] = std::ldexp(static_cast<double>(integers.at[p][k]), low);
            }
        }
        const ExactSigns expected(integers);
        DifferenceSigns signs(points, std::ldexp(1.0, -low));
        for (const int own : {0, 3}) {
            DifferenceSigns fresh(points, std::ldexp(1.0, -low));
            ASSERT_EQ(fresh.sides(own, 3 - own), expected.sides(own, 3 - own)) << i;
            const int axis = signs.normal_axis(own);
            ASSERT_EQ(axis < 0, expected.normal_axis(own) < 0) << i;
            ASSERT_TRUE(axis < 0 || expected.orient2d(own, own + 1, own + 2, axis) != 0) << i;
        }
        ASSERT_EQ(signs.orient3d(0, 1, 3, 4), expected.orient3d(0, 1, 3, 4)) << i;
        ASSERT_EQ(signs.orient3d(5, 2, 0, 4), expected.orient3d(5, 2, 0, 4)) << i;
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(signs.orient2d(0, 1, 2, axis), expected.orient2d(0, 1, 2, axis)) << i;
            ASSERT_EQ(signs.orient2d(5, 1, 3, axis), expected.orient2d(5, 1, 3, axis)) << i;
            ASSERT_EQ(signs.compare(0, 4, axis), expected.compare(0, 4, axis)) << i;
        }
        integer_count += signs.has_used_integers();
    }
    EXPECT_GT(integer_count, 6000);
    EXPECT_LT(integer_count, 54000);
}

// Where every product has a factor of zero there is nothing to ask integers for, whatever the other factors.
TEST(DifferenceSigns, AxisAlignedFacesNeedNoIntegers) {
    const double x = 0.1, y = 0.7, z = 1.3;
    const Points<6> points{Point{0, 0, z}, Point{x, 0, z}, Point{0, y, z},
                           Point{0, y, z}, Point{x, y, z}, Point{x, y, -z}};
    DifferenceSigns signs(points, 0x1p55);
    EXPECT_EQ(signs.sides(0, 3), (Sides{0, 0, -1}));
    EXPECT_EQ(signs.normal_axis(0), 2);
    EXPECT_EQ(signs.normal_axis(3), 1);
    EXPECT_EQ(signs.orient2d(0, 1, 2, 0), 0);
    EXPECT_FALSE(signs.has_used_integers());
}

// The derivation's constants: five factors a product of three differences, two a minor's.
TEST(DifferenceSigns, ConstantsAreTheDerivedOnes) {
    EXPECT_EQ(determinant_error, 6 * 0x1p-52);
    EXPECT_EQ(minor_error, 3 * 0x1p-52);
}

}  // namespace
}  // namespace ecods::exact::difference_signs_test
