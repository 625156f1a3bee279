// A triangle that turns beside one whose corners go straight: degrees and widths of their polynomials, and places and
// bounds in doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/measure/contact/turn_and_straight_points.hpp"
#include "unit/exact/rational_motion.hpp"

namespace ecods::exact::turn_and_straight_test {
namespace {

using turns_test::any_motion;
using turns_test::Motion;
using turns_test::OneTurn;
using turns_test::Place;
using turns_test::Rational;

// Degrees and widths beside a straight motion, as the header derives them.
TEST(TurnAndStraight, DegreesAndWidths) {
    scenes::Random random(45);
    constexpr int n = 20, m = 20;
    const auto number = [&] { return std::round(random.uniform(-0x1p20, 0x1p20)); };
    const auto vector = [&] { return Vec3(number(), number(), number()); };
    int widest = 0;
    for (int run = 0; run < 20; ++run) {
        Motion motion;
        for (Vec3& corner : motion.corners) corner = vector();
        motion.ends = {vector(), vector(), vector()};
        motion.turns[0] = {number(), vector(), vector(), vector()};
        const auto expect = [&](const Quintic& p, int degree) {
            EXPECT_EQ(p.degree(), degree);
            for (int i = 0; i <= degree; ++i) {
                const Integer size = p[i].sign() < 0 ? -p[i] : p[i];
                int bits = 0;
                while (compare(size >> bits, Integer()) > 0) ++bits;
                widest = std::max(widest, bits);
                EXPECT_LE(bits, 2 * m + 3 * n + 16);
            }
        };
        motion.with_triangles([&](BothTurningTriangles& triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_EQ(triangles.difference(i, i, 0).degree(), 3);
                EXPECT_EQ(triangles.turn({0, i, i})[0].degree(), 4);
                EXPECT_EQ(triangles.turn({1, i, i})[0].degree(), 3);
                expect(triangles.corner_volume(0, i), 5);
                expect(triangles.corner_volume(1, i), 3);
                for (std::size_t j = 0; j < 3; ++j) expect(triangles.edge_volume(i, j), 4);
            }
        });
    }
    EXPECT_GT(widest, 2 * m + 3 * n);
}

// The triangle that turns is within its margins of a straight motion at the same time, the other one is on one, and no
// two corners go farther than their way.
TEST(TurnAndStraight, MarginsAndWays) {
    scenes::Random random(46);
    int bounded = 0;
    double nearest = 0;
    for (int run = 0; run < 400; ++run) {
        Motion motion = any_motion(random);
        motion.ends = {motion.corners[1], motion.corners[5], motion.corners[0]};
        const OneTurn& turn = motion.turns[0];
        const TurnAngles angles(turn.w, turn.v);
        const auto point_of = [](const Vec3& v) { return Point{v[0], v[1], v[2]}; };
        TurnAndStraightPoints points{
            {},
            0x1p-1000,
            {point_of(turn.from), point_of(turn.to - turn.from), 0x1p-1000, 0x1p-1000, &angles},
            {},
            0x1p-1000};
        for (std::size_t i = 0; i < 6; ++i) points.start[i] = point_of(motion.corners[i]);
        for (std::size_t i = 0; i < 3; ++i) points.end[i] = point_of((*motion.ends)[i]);
        const TurnAndStraightCorners corners(points);
        const double from = random.uniform(0, 1), length = std::min(1 - from, random.uniform(0, 0.25));
        const auto start = corners.at(from), end = corners.at(from + length);
        const Point margins = corners.margins(start, end);
        const double way = corners.way(start, length);
        for (const double part : {0.25, 0.5, 0.75}) {
            const auto at = corners.at(from + part * length);
            std::array<double, 2> most{};
            for (std::size_t i = 0; i < 6; ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    most[i / 3] = std::max(most[i / 3], std::abs(at.points[i][k] - start.points[i][k]));
                    const double off =
                        std::abs(at.points[i][k] - ((1 - part) * start.points[i][k] + part * end.points[i][k]));
                    EXPECT_LE(off, (i < 3 ? margins[k] : 0) + 1e-12) << run << ' ' << part;
                    if (margins[k] > 1e-6) nearest = std::max(nearest, off / margins[k]);
                }
            }
            EXPECT_LE(most[0] + most[1], way + 1e-12) << run << ' ' << part;
            bounded += margins[0] < 1 && way < 10;
        }
    }
    EXPECT_GT(bounded, 300);
    EXPECT_GT(nearest, 0.6);
}

// Places in doubles are off from those in rational numbers by less than the bound of gaps says, also where the straight
// motion ends far away or its errors are large.
TEST(TurnAndStraight, Places) {
    scenes::Random random(47);
    for (int run = 0; run < 200; ++run) {
        Motion motion = any_motion(random);
        const double far = std::ldexp(1.0, static_cast<int>(random.below(80)) - 20);
        const auto number = [&] { return random.uniform(-1, 1); };
        motion.ends.emplace();
        for (Vec3& end : *motion.ends) end = far * Vec3(number(), number(), number());
        const OneTurn& turn = motion.turns[0];
        const TurnAngles angles(turn.w, turn.v);
        const double end_error = random.below(2) == 0 ? 0x1p-1000 : 0x1p-20 * far;
        const auto point_of = [](const Vec3& v) { return Point{v[0], v[1], v[2]}; };
        TurnAndStraightPoints points{
            {},
            0x1p-1000,
            {point_of(turn.from), point_of(turn.to - turn.from), 0x1p-1000, 0x1p-1000, &angles},
            {},
            end_error};
        double size = 0;
        for (std::size_t i = 0; i < 6; ++i) points.start[i] = point_of(motion.corners[i]);
        for (std::size_t i = 0; i < 3; ++i) {
            points.end[i] = point_of((*motion.ends)[i]);
            for (double& x : points.end[i]) x += 0.99 * random.uniform(-1, 1) * end_error;
        }
        const TurnAndStraightCorners corners(points);
        if (!corners.is_bounded()) continue;
        for (const double s : {0x1p-30, 0.25, random.uniform(0, 1), 1.0}) {
            const auto at = corners.at(s);
            const std::array<Place, 6> x = motion.at(Rational(s));
            // The scale is a power of two: that of the greatest gap, as computed.
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t i = 0; i < 3; ++i) {
                    for (std::size_t j = 3; j < 6; ++j) {
                        const double gap = at.points[j][k] - at.points[i][k],
                                     real = Rational(x[j][k] - x[i][k]).get_d();
                        size =
                            std::abs(gap) > 0x1p-10 && size == 0 ? std::exp2(std::round(std::log2(gap / real))) : size;
                        if (size == 0) continue;
                        EXPECT_LE(std::abs(gap - size * real), at.error[k]) << run << ' ' << s << ' ' << k;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace ecods::exact::turn_and_straight_test
