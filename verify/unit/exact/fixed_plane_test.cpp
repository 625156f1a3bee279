// Roundings in fixed precision beside those of integers of any length, of exact points and of points off by some units.
#include "exact/measure/round/fixed_plane.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <random>

#include "environment/float_mode.hpp"
#include "exact/measure/round/direction.hpp"
#include "exact/measure/round/limb_vectors.hpp"
#include "exact/measure/round/squared_distance.hpp"

namespace ecods::exact::fixed_plane_test {
namespace {

using Vector = FixedPlane::Vector;
using Corners = std::array<Vector, 3>;
using Numbers = std::mt19937_64;

std::array<Limbs<2>, 3> limbs_of(const Vector& v) {
    std::array<Limbs<2>, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto bits = static_cast<Uint128>(v[k]);
        result[k] = {static_cast<std::uint64_t>(bits), static_cast<std::uint64_t>(bits >> 64)};
    }
    return result;
}

// The same in limbs.
struct Plane {
    explicit Plane(const Corners& m) {
        const auto first = limbs_of(m[0]);
        n = cross<2>(difference<2>(limbs_of(m[1]), first), difference<2>(limbs_of(m[2]), first));
        h = dot<4, 2>(n, difference<2>(first, {}));
    }
    bool is_flat() const { return is_zero<8>(dot<4, 4>(n, n).limbs); }
    SquaredDistance square(int unit) const {
        SquaredDistance result;
        result.num.assign(multiply<6, 6>(h.limbs, h.limbs));
        result.den.assign(dot<4, 4>(n, n).limbs);
        result.exponent = unit;
        return result;
    }

    LimbVector<4> n;
    Magnitude<6> h;
};

Int128 random_integer(Numbers& numbers, int bits) {
    const Uint128 all = Uint128{numbers()} << 64 | numbers();
    const auto size = static_cast<Int128>(all >> (128 - bits));
    return (numbers() & 1) != 0 ? -size : size;
}

// Corners below 2^122: of any digits, of few, nearly in one line, in a plane that is nearly one through the origin, or
// at right angles to an axis.
Corners random_corners(Numbers& numbers) {
    Corners m;
    const int bits = static_cast<int>(2 + numbers() % 120), shift = static_cast<int>(numbers() % 30);
    for (Vector& v : m) {
        for (Int128& x : v) x = random_integer(numbers, bits);
    }
    switch (numbers() % 5) {
        case 0:
            for (std::size_t k = 0; k < 3; ++k) m[2][k] = 2 * m[1][k] - m[0][k] + random_integer(numbers, 3);
            for (Int128& x : m[2]) x = x / 4;
            break;
        case 1:
            for (std::size_t k = 0; k < 3; ++k) m[0][k] = (m[1][k] + m[2][k]) / 2 + random_integer(numbers, 1 + shift);
            break;
        case 2:
            m[1][numbers() % 3] = m[0][0];
            m[1][0] = m[2][0] = m[0][0];
            break;
        case 3:
            m[1][2] = m[2][2] = m[0][2];
            m[1][1] = m[0][1];
            break;
        default:
            break;
    }
    return m;
}

void expect_right(const FixedPlane& fixed, const Plane& exact, int unit, bool is_exact, int& certain) {
    const std::optional<int> side = fixed.side();
    if (is_exact) {
        ASSERT_TRUE(side);
    }
    if (!side) return;
    EXPECT_EQ(*side, sign<6>(exact.h));
    if (*side < 0) return;
    const std::optional<double> distance = fixed.distance();
    const std::optional<Vec3> direction = fixed.direction();
    if (distance && *side > 0) {
        ++certain;
        EXPECT_EQ(*distance, round_root(exact.square(unit)));
    }
    if (direction) {
        const Vec3 expected = round_direction<4>(exact.n);
        for (int k = 0; k < 3; ++k) EXPECT_EQ((*direction)[k], expected[k]);
    }
}

TEST(FixedPlane, RoundsAsLongIntegersDo) {
    Numbers numbers(1);
    int certain = 0, count = 0;
    for (int i = 0; i < 4000; ++i) {
        const Corners m = random_corners(numbers);
        const Plane exact(m);
        if (exact.is_flat()) continue;
        const int unit = static_cast<int>(numbers() % 600) - 400;
        const environment::InFloatMode in(environment::float_modes[numbers() % 8]);
        count += sign<6>(exact.h) > 0;
        expect_right(FixedPlane(m, unit, true), exact, unit, true, certain);
    }
    EXPECT_GT(certain, count * 9 / 10);
}

TEST(FixedPlane, IsRightWhereItIsCertainOfPointsThatAreOff) {
    Numbers numbers(2);
    int certain = 0, count = 0;
    for (int i = 0; i < 4000; ++i) {
        const Corners m = random_corners(numbers);
        const Plane exact(m);
        if (exact.is_flat()) continue;
        Corners off = m;
        for (Vector& v : off) {
            for (Int128& x : v) x += static_cast<Int128>(numbers() % 9) - 4;
        }
        const environment::InFloatMode in(environment::float_modes[numbers() % 8]);
        count += sign<6>(exact.h) > 0;
        expect_right(FixedPlane(off, -100, false), exact, -100, false, certain);
    }
    EXPECT_GT(certain, count / 4);
}

TEST(FixedPlane, ComparesAsLongIntegersDo) {
    Numbers numbers(3);
    int certain = 0;
    for (int i = 0; i < 4000; ++i) {
        const Corners m = random_corners(numbers);
        Corners other = random_corners(numbers);
        if (numbers() % 2 == 0) {
            other = m;
            other[numbers() % 3][numbers() % 3] += random_integer(numbers, 1 + static_cast<int>(numbers() % 60));
        }
        const Plane x(m), y(other);
        if (x.is_flat() || y.is_flat() || sign<6>(x.h) <= 0 || sign<6>(y.h) <= 0) continue;
        const std::optional<int> sign = FixedPlane(m, 0, true).compare(FixedPlane(other, 0, true));
        if (!sign) continue;
        ++certain;
        EXPECT_EQ(*sign, compare(x.square(0), y.square(0)));
    }
    EXPECT_GT(certain, 500);
}

}  // namespace
}  // namespace ecods::exact::fixed_plane_test
