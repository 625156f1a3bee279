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
#include "unit/exact/rational_place.hpp"

namespace ecods::exact::both_turning_triangles_test {
namespace {

using turns_test::cross_of;
using turns_test::dot_of;
using turns_test::operator-;
using turns_test::Place;
using turns_test::place_of;
using turns_test::Rational;

// A turn as its header defines it: q is (w, v), and the pivot goes from one point to another.
struct OneTurn {
    double w;
    Vec3 v, from, to;

    Place at(const Vec3& start, const Rational& s) const {
        const Place c = place_of(from), way = place_of(to) - c, g = place_of(start) - c;
        const Rational a = 1 + s * (Rational(w) - 1);
        const Place b = {s * v[0], s * v[1], s * v[2]}, once = cross_of(b, g);
        const Rational norm = a * a + dot_of(b, b), beside = 2 * dot_of(b, g), of_g = a * a - dot_of(b, b);
        Place x;
        for (std::size_t k = 0; k < 3; ++k) {
            x[k] = c[k] + s * way[k] + (of_g * g[k] + beside * b[k] + 2 * a * once[k]) / norm;
        }
        return x;
    }
};

struct Motion {
    std::array<Vec3, 6> corners;
    std::array<OneTurn, 2> turns;

    template <class Use>
    auto with_triangles(Use&& use) const {
        const Pose world;
        PosedPoints<10> points;
        for (std::size_t i = 0; i < 6; ++i) points[i] = {&world, &corners[i]};
        for (std::size_t i = 0; i < 2; ++i) {
            points[6 + 2 * i] = {&world, &turns[i].from};
            points[7 + 2 * i] = {&world, &turns[i].to};
        }
        const TurnIntegers a(turns[0].w, turns[0].v), b(turns[1].w, turns[1].v);
        return with_integers(points, [&](const auto& integers) {
            BothTurningTriangles triangles(integers, a, b);
            return use(triangles);
        });
    }
};

Motion any_motion(scenes::Random& random) {
    const auto number = [&](std::uint32_t most) { return static_cast<double>(random.below(2 * most + 1)) - most; };
    const auto vector = [&] { return Vec3(number(2), number(2), number(2)); };
    Motion motion;
    for (Vec3& corner : motion.corners) corner = vector();
    for (OneTurn& turn : motion.turns) {
        turn = {number(3) / 2, vector(), vector(), vector()};
        if (turn.v.isZero()) turn.w = 1.5;
        if (random.below(8) == 0) turn.v = Vec3(0, 0, 1);
        if (random.below(3) == 0) turn.to = turn.from;
    }
    if (random.below(4) == 0) motion.turns[1] = motion.turns[0];
    return motion;
}

TEST(BothTurningTriangles, SignsAreThoseOfRationalPlaces) {
    scenes::Random random(42);
    int degree = 0;
    for (int run = 0; run < 60; ++run) {
        const Motion motion = any_motion(random);
        motion.with_triangles([&](BothTurningTriangles& triangles) {
            for (int time = 0; time <= 8; ++time) {
                const BinaryFraction s{Integer(std::int64_t{time}), 3};
                std::array<Place, 6> x;
                for (std::size_t i = 0; i < 6; ++i) {
                    x[i] = motion.turns[i / 3].at(motion.corners[i], Rational(time) / 8);
                }
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
    EXPECT_EQ(degree, 5);
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
