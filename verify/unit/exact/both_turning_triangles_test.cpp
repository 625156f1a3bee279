// The polynomials of two triangles that turn beside rational numbers: places of corners at rational times, and what is
// asked of them.
#include "exact/measure/contact/both_turning_triangles.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/measure/contact/both_turning_points.hpp"
#include "exact/measure/contact/first_meeting.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "scenes/random.hpp"
#include "unit/exact/rational_motion.hpp"

namespace ecods::exact::both_turning_triangles_test {
namespace {

using turns_test::any_motion;
using turns_test::cross_of;
using turns_test::dot_of;
using turns_test::Motion;
using turns_test::OneTurn;
using turns_test::operator-;
using turns_test::Place;
using turns_test::Rational;

TEST(BothTurningTriangles, SignsAreThoseOfRationalPlaces) {
    scenes::Random random(42);
    std::array<int, 2> degrees{};  // of both turns, and of a turn and a straight motion
    for (int run = 0; run < 120; ++run) {
        const Motion motion = any_motion(random);
        motion.with_triangles([&](BothTurningTriangles& triangles) {
            for (int time = 0; time <= 8; ++time) {
                const BinaryFraction s{Integer(std::int64_t{time}), 3};
                const std::array<Place, 6> x = motion.at(Rational(time) / 8);
                int& degree = degrees[motion.ends ? 1 : 0];
                const auto expect = [&](const Quintic& p, const Rational& value) {
                    degree = std::max(degree, p.degree());
                    EXPECT_EQ(p.sign_at(s), sgn(value)) << run << ' ' << time;
                };
                for (std::size_t i = 0; i < 3; ++i) {
                    for (std::size_t j = 0; j < 3; ++j) {
                        for (std::size_t k = 0; k < 3; ++k) {
                            expect(triangles.difference(i, j, k), x[i][k] - x[3 + j][k]);
                            for (const std::size_t side : {0, 1}) {
                                const Place &from = x[3 * (1 - side) + j], &to = x[3 * (1 - side) + next_corner(j)],
                                            &corner = x[3 * side + i];
                                expect(triangles.turn({side, i, j})[k], cross_of(to - from, corner - from)[k]);
                            }
                        }
                        const Place &p = x[i], &q = x[3 + j];
                        expect(triangles.edge_volume(i, j),
                               dot_of(cross_of(x[next_corner(i)] - p, x[3 + next_corner(j)] - q), q - p));
                    }
                    for (const std::size_t side : {0, 1}) {
                        const std::size_t first = 3 * (1 - side);
                        const Place n = cross_of(x[first + 1] - x[first], x[first + 2] - x[first]);
                        expect(triangles.corner_volume(side, i), dot_of(n, x[3 * side + i] - x[first]));
                    }
                }
            }
        });
    }
    EXPECT_EQ(degrees, (std::array{5, 5}));
}

// Turns of a face's corner add up to its normal, and those of an edge's ends differ by a cross product, as the decision
// assumes: all with one factor, which is positive.
TEST(BothTurningTriangles, TurnsHaveOneFactor) {
    scenes::Random random(43);
    for (int run = 0; run < 20; ++run) {
        const Motion motion = any_motion(random);
        motion.with_triangles([&](BothTurningTriangles& triangles) {
            const auto sum_of = [&](std::size_t side, std::size_t corner, std::size_t axis) {
                return triangles.turn({side, corner, 0})[axis] + triangles.turn({side, corner, 1})[axis] +
                       triangles.turn({side, corner, 2})[axis];
            };
            const auto difference_of = [&](std::size_t side, std::size_t corner, std::size_t edge, std::size_t axis) {
                return triangles.turn({side, next_corner(corner), edge})[axis] -
                       triangles.turn({side, corner, edge})[axis];
            };
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (const std::size_t side : {0, 1}) {
                    EXPECT_TRUE((sum_of(side, 0, axis) - sum_of(side, 1, axis)).is_zero());
                    EXPECT_TRUE((sum_of(side, 0, axis) - sum_of(side, 2, axis)).is_zero());
                }
                for (std::size_t i = 0; i < 3; ++i) {
                    for (std::size_t j = 0; j < 3; ++j) {
                        // b x a of the corner's edge a, and a x b
                        EXPECT_TRUE((difference_of(0, i, j, axis) + difference_of(1, j, i, axis)).is_zero());
                    }
                }
            }
        });
    }
}

// Two points on one circle, turning towards each other at different speeds, and two that keep a quarter between them.
TEST(BothTurningTriangles, KnownMeetings) {
    const auto meeting_of = [](const Vec3& a, const OneTurn& turn_a, const Vec3& b, const OneTurn& turn_b) {
        const Motion motion{{a, a, a, b, b, b}, {turn_a, turn_b}};
        return motion.with_triangles([](BothTurningTriangles& triangles) { return first_meeting(triangles); });
    };
    const OneTurn forth{0, {0, 0, 1}, Vec3::Zero(), Vec3::Zero()}, back{0, {0, 0, -1}, Vec3::Zero(), Vec3::Zero()};
    // At 1/3 one is at (3, 4, 0), and the other, from (-5, 0, 0), at (-3, 4, 0); they meet half-way.
    const auto half = meeting_of({5, 0, 0}, forth, {-5, 0, 0}, back);
    ASSERT_TRUE(half);
    EXPECT_EQ(half->time, 0.5);
    EXPECT_FALSE(meeting_of({5, 0, 0}, forth, {0, 5, 0}, forth));
    // By time 1/3 one has turned to (3, 4, 0), and by then the other has glided there.
    const OneTurn glide{1, Vec3::Zero(), Vec3::Zero(), {3, 0, 0}};
    const auto third = meeting_of({5, 0, 0}, forth, {2, 4, 0}, glide);
    ASSERT_TRUE(third);
    EXPECT_EQ(third->time, 1 / 3.0);
    // A straight motion brings the other one there at the same time; with a nearer end, the motion comes too late.
    const auto beside = [&](const Vec3& b, const Vec3& end) {
        const Vec3 a(5, 0, 0);
        const Motion motion{{a, a, a, b, b, b}, {forth, {}}, {{end, end, end}}};
        return motion.with_triangles([](BothTurningTriangles& triangles) { return first_meeting(triangles); });
    };
    EXPECT_EQ(beside({2, 4, 0}, {5, 4, 0}).value().time, 1 / 3.0);
    EXPECT_FALSE(beside({2, 4, 0}, {4, 4, 0}));
}

// In a piece of time the difference of two corners is within the margins of a straight motion at the same time, and no
// two corners go farther than their way, in doubles; turns are fast and slow.
TEST(BothTurningTriangles, MarginsAndWays) {
    scenes::Random random(44);
    int bounded = 0;
    double nearest = 0;
    for (int run = 0; run < 400; ++run) {
        const Motion motion = any_motion(random);
        std::array<TurnAngles, 2> angles;
        BothTurningPoints points{{}, 0x1p-1000, {}};
        const auto point_of = [](const Vec3& v) { return Point{v[0], v[1], v[2]}; };
        for (std::size_t i = 0; i < 6; ++i) points.start[i] = point_of(motion.corners[i]);
        for (std::size_t i = 0; i < 2; ++i) {
            const OneTurn& turn = motion.turns[i];
            angles[i] = TurnAngles(turn.w, turn.v);
            points.turns[i] = {point_of(turn.from), point_of(turn.to - turn.from), 0x1p-1000, 0x1p-1000, &angles[i]};
        }
        const BothTurningCorners corners(points);
        const double from = random.uniform(0, 1), length = std::min(1 - from, random.uniform(0, 0.25));
        const auto start = corners.at(from), end = corners.at(from + length);
        const Point margins = corners.margins(start, end);
        for (const double part : {0.25, 0.5, 0.75}) {
            const auto at = corners.at(from + part * length);
            const double way = corners.way(start, length);
            double most_a = 0, most_b = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t i = 0; i < 3; ++i) {
                    most_a = std::max(most_a, std::abs(at.points[i][k] - start.points[i][k]));
                    most_b = std::max(most_b, std::abs(at.points[3 + i][k] - start.points[3 + i][k]));
                    for (std::size_t j = 3; j < 6; ++j) {
                        const auto gap = [&](const BothTurningCorners::At& x) {
                            return x.points[j][k] - x.points[i][k];
                        };
                        const double off = std::abs(gap(at) - ((1 - part) * gap(start) + part * gap(end)));
                        EXPECT_LE(off, margins[k] + 1e-12) << run << ' ' << part;
                        if (margins[k] > 1e-6) nearest = std::max(nearest, off / margins[k]);
                    }
                }
            }
            EXPECT_LE(most_a + most_b, way + 1e-12) << run << ' ' << part;
            bounded += margins[0] < 1 && way < 10;
        }
    }
    EXPECT_GT(bounded, 300);
    EXPECT_GT(nearest, 0.6);
}

}  // namespace
}  // namespace ecods::exact::both_turning_triangles_test
