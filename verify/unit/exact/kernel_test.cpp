// The kernels against each other and against arithmetic of the boost library, at the limits of their widths.

#include "exact/number/kernel.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "exact/point/integer_points.hpp"
#include "exact/sign/exact_signs.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::kernel_test {
namespace {

using boost::multiprecision::cpp_int;

using SixBig = std::array<std::array<cpp_int, 3>, 6>;

// A number of exactly `bits` bits, or one of the extremes.
cpp_int number(scenes::Random& random, int bits) {
    cpp_int x = 0;
    switch (random.below(4)) {
        case 0:
            x = (cpp_int(1) << bits) - 1;
            break;
        case 1:
            x = cpp_int(1) << (bits - 1);
            break;
        default:
            for (int i = 0; i < bits; i += 32) x = (x << 32) + random.below(0xffffffff);
            x &= (cpp_int(1) << bits) - 1;
    }
    return random.below(2) == 0 ? x : cpp_int(-x);
}

SixBig points(scenes::Random& random, int bits) {
    SixBig p;
    for (auto& point : p) {
        for (auto& x : point) x = number(random, bits);
    }
    // Coplanar and collinear ones in part.
    if (random.below(2) == 0) {
        for (std::size_t k = 0; k < 3; ++k) p[3][k] = p[0][k];
    }
    if (random.below(4) == 0) {
        for (std::size_t k = 0; k < 3; ++k) p[5][k] = p[4][k];
    }
    return p;
}

template <int L>
Limbs<L> to_limbs(cpp_int x) {
    const cpp_int modulus = cpp_int(1) << (64 * L);
    if (x < 0) x += modulus;
    Limbs<L> limbs;
    for (auto& limb : limbs) {
        limb = static_cast<std::uint64_t>(x & 0xffffffffffffffffu);
        x >>= 64;
    }
    return limbs;
}

int sign_of(const cpp_int& x) {
    return x < 0 ? -1 : x > 0;
}

int orient3d(const SixBig& p, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const auto x = [&](std::size_t q, std::size_t k) { return cpp_int(p[q][k] - p[a][k]); };
    return sign_of(x(b, 0) * (x(c, 1) * x(d, 2) - x(c, 2) * x(d, 1)) -
                   x(b, 1) * (x(c, 0) * x(d, 2) - x(c, 2) * x(d, 0)) +
                   x(b, 2) * (x(c, 0) * x(d, 1) - x(c, 1) * x(d, 0)));
}

int orient2d(const SixBig& p, std::size_t a, std::size_t b, std::size_t c, std::size_t axis) {
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    return sign_of((p[b][i] - p[a][i]) * (p[c][j] - p[a][j]) - (p[b][j] - p[a][j]) * (p[c][i] - p[a][i]));
}

template <class Kernel>
void expect_right(const IntegerPoints<Kernel, 6>& points, const SixBig& p) {
    const ExactSigns signs(points);
    for (const std::size_t own : {0u, 3u}) {
        const std::size_t other = 3 - own;
        const Sides sides = signs.sides(static_cast<int>(own), static_cast<int>(other));
        for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(sides[i], orient3d(p, own, own + 1, own + 2, other + i));
    }
    ASSERT_EQ(signs.orient3d(1, 4, 2, 5), orient3d(p, 1, 4, 2, 5));
    ASSERT_EQ(signs.orient3d(3, 0, 5, 4), orient3d(p, 3, 0, 5, 4));
    for (int axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(signs.orient2d(2, 5, 1, axis), orient2d(p, 2, 5, 1, static_cast<std::size_t>(axis)));
        ASSERT_EQ(signs.orient2d(0, 3, 4, axis), orient2d(p, 0, 3, 4, static_cast<std::size_t>(axis)));
        const auto k = static_cast<std::size_t>(axis);
        ASSERT_EQ(signs.compare(4, 1, axis), sign_of(p[4][k] - p[1][k]));
        ASSERT_EQ(signs.compare(3, 0, axis), sign_of(p[3][k] - p[0][k]));
    }
}

// `coordinate` makes a coordinate of the kernel of an integer.
template <class Kernel, class Coordinate>
void check(std::uint32_t seed, int runs, const Coordinate& coordinate) {
    scenes::Random random(seed);
    for (int i = 0; i < runs; ++i) {
        const int bits = i % 2 == 0 ? Kernel::coordinate_bits : 1 + i % Kernel::coordinate_bits;
        const SixBig p = points(random, bits);
        IntegerPoints<Kernel, 6> kernel;
        for (std::size_t q = 0; q < 6; ++q) {
            for (std::size_t k = 0; k < 3; ++k) kernel.at[q][k] = coordinate(p[q][k]);
        }
        expect_right(kernel, p);
    }
}

template <int L>
void check_limbs(int runs) {
    check<LimbKernel<L>>(L, runs, to_limbs<L>);
}

TEST(Kernel, OneLimb) {
    check<OneLimbKernel>(1, 20000, [](const cpp_int& x) { return static_cast<std::int64_t>(x); });
}
TEST(Kernel, TwoLimbs) {
    check<TwoLimbKernel>(2, 20000, [](const cpp_int& x) {
        const Limbs<2> limbs = to_limbs<2>(x);
        return static_cast<Int128>(Uint128{limbs[1]} << 64 | limbs[0]);
    });
}

TEST(Kernel, TwoSmallLimbs) {
    check_limbs<2>(20000);
}
TEST(Kernel, ThreeLimbs) {
    check_limbs<3>(5000);
}
TEST(Kernel, FourLimbs) {
    check_limbs<4>(5000);
}
TEST(Kernel, EightLimbs) {
    check_limbs<8>(2000);
}
TEST(Kernel, TwentyLimbs) {
    check_limbs<20>(500);
}
TEST(Kernel, WidestLimbs) {
    check_limbs<limb_count_max>(50);
}

}  // namespace
}  // namespace ecods::exact::kernel_test
