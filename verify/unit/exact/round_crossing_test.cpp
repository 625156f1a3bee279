// The point in which a line crosses a triangle's plane, rounded from leading digits, beside rationals: never another
// number than the nearest, and nearly always one.
#include "exact/measure/line/round_crossing.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/number/dyadic.hpp"
#include "integers.hpp"
#include "measured_pairs.hpp"
#include "oracle/nearest.hpp"
#include "oracle_pair.hpp"

namespace ecods::exact::round_crossing_test {
namespace {

using Vector = TwoLimbKernel::Point;
using Corners = std::array<Vector, 3>;

RationalPoint to_rationals(const Vector& v) {
    return {testing::mpz_of(v[0]), testing::mpz_of(v[1]), testing::mpz_of(v[2])};
}

struct Count {
    int asked = 0, known = 0;
};

void check(const LineInUnits& line, const Corners& corners, Count& count) {
    const RationalPoint p = to_rationals(corners[0]), d = to_rationals(line.direction);
    const RationalPoint n = cross(to_rationals(corners[1]) - p, to_rationals(corners[2]) - p);
    const mpq_class den = dot(n, d);
    if (sgn(den) == 0 || sgn(dot(n, p)) * sgn(den) <= 0) return;
    const mpq_class s = dot(n, p) / den;
    ++count.asked;
    RoundedCrossing crossing;
    const bool is_known = round_crossing(line, corners, crossing);
    for (const int environment : environments) {
        RoundedCrossing other;
        const bool is_known_there = in_environment(environment, [&] { return round_crossing(line, corners, other); });
        ASSERT_EQ(is_known_there, is_known);
        if (!is_known) continue;
        ASSERT_EQ(bits(other.at.parameter), bits(crossing.at.parameter));
        for (int k = 0; k < 3; ++k) ASSERT_EQ(bits(other.at.point[k]), bits(crossing.at.point[k]));
    }
    if (!is_known) return;
    ++count.known;
    ASSERT_EQ(crossing.facing, sgn(den));
    ASSERT_EQ(bits(crossing.at.parameter), bits(nearest(s)));
    for (int k = 0; k < 3; ++k) {
        const auto row = static_cast<std::size_t>(k);
        const mpq_class point = mpq_class(line.from[k]) + testing::times_power(d[row], line.unit) * s;
        ASSERT_EQ(bits(crossing.at.point[k]), bits(nearest(point))) << k;
    }
}

// Below 2^width in size.
Int128 any_integer(Random& random, int width) {
    Uint128 x = 0;
    for (int i = 0; i < 5; ++i) x = x << 31 | random.below(1u << 31);
    const auto size = static_cast<Int128>(x & ((Uint128{1} << width) - 1));
    return random.below(2) == 0 ? size : -size;
}
Vector any_vector(Random& random, int width) {
    const Int128 x = any_integer(random, width), y = any_integer(random, width);
    return {x, y, any_integer(random, width)};
}
Vector sum(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

LineInUnits any_line(Random& random, int width, int unit) {
    const double size = std::ldexp(1.0, unit + width);
    const double x = random.uniform(-1, 1) * size, y = random.uniform(-1, 1) * size;
    return {Vec3(x, y, random.uniform(-1, 1) * size), any_vector(random, width), unit};
}

TEST(RoundCrossing, AsRationals) {
    Random random(1);
    for (const int width : {1, 2, 5, 20, 53, 60, 90, 110, 122}) {
        Count count;
        for (int i = 0; i < 2000; ++i) {
            const int edge = i % 3 == 0 ? std::max(width - 8, 1) : std::max(width - 1, 1);
            const LineInUnits line = any_line(random, width, i % 5 == 0 ? -1070 : -width + 2);
            const Vector p = any_vector(random, std::max(width - 1, 1));
            const Corners corners{p, sum(p, any_vector(random, edge)), sum(p, any_vector(random, edge))};
            ASSERT_NO_FATAL_FAILURE(check(line, corners, count)) << width << ", " << i;
        }
        EXPECT_GT(count.asked, 200) << width;
        EXPECT_GE(count.known, width < 20 ? 0 : count.asked * 3 / 4) << width;
    }
}

// Triangles that are nearly segments, and lines nearly in their planes: sums that cancel.
TEST(RoundCrossing, OfSumsThatCancel) {
    Random random(2);
    Count count;
    for (int i = 0; i < 20000; ++i) {
        const int width = 100 + static_cast<int>(random.below(21)), beside = 1 + static_cast<int>(random.below(100));
        LineInUnits line = any_line(random, width, -width);
        const Vector p = any_vector(random, width), u = any_vector(random, width);
        Vector v = sum(u, any_vector(random, beside));
        if (i % 2 == 0) v = any_vector(random, width);
        if (i % 4 < 2) line.direction = sum(u, any_vector(random, beside));
        ASSERT_NO_FATAL_FAILURE(check(line, {p, sum(p, u), sum(p, v)}, count)) << i;
    }
    EXPECT_GT(count.known, count.asked / 2);
}

// Parameters and coordinates that are doubles, half-way between two, or beside that by little.
TEST(RoundCrossing, HalfWayAndBesideIt) {
    Random random(3);
    Count count;
    for (int i = 0; i < 20000; ++i) {
        // A plane across the first axis, at s = at / whole.
        const int width = 60 + static_cast<int>(random.below(60));
        const Int128 whole = Int128{1} << width;
        const Int128 half = Int128{1} << (width - 54), kept = any_integer(random, 53) | Int128{1} << 52;
        const Int128 size = (kept < 0 ? -kept : kept) * 2 * half;
        const Int128 at = size + (i % 3 == 0 ? 0 : half) + static_cast<int>(random.below(9)) - 4;
        const Vector q{at, 3 * whole / 8, 0}, r{at, 0, whole / 4};
        LineInUnits line = any_line(random, width, -width);
        line.direction = {whole, i % 5 == 0 ? 0 : any_integer(random, width), 1};
        line.from = Vec3(i % 2 == 0 ? 0 : 1, -1, 0x1p-60);
        ASSERT_NO_FATAL_FAILURE(check(line, {Vector{at, 0, 0}, q, r}, count)) << i;
    }
    EXPECT_GT(count.asked, 15000);
    EXPECT_GT(count.known, 1000);
}

}  // namespace
}  // namespace ecods::exact::round_crossing_test
