// The polynomials of a triangle that turns beside rational numbers: places of corners at rational times, and what is
// asked of them.
#include "exact/measure/contact/turning_triangles.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "exact/measure/distance/feature_pair.hpp"
#include "scenes/random.hpp"
#include "unit/exact/rational_place.hpp"

namespace ecods::exact::turning_triangles_test {
namespace {

using turns_test::cross_of;
using turns_test::dot_of;
using turns_test::operator-;
using turns_test::Place;
using turns_test::place_of;
using turns_test::Rational;

// A motion as the headers of turns and ways define it: the quaternion goes from `from` to (w, v), the pivot from
// points[6] to points[7], and was at points[10] at the start of the way; and the other triangle is translated by
// points[9] - points[8].
struct Motion {
    double w;
    Vec3 v;
    std::array<Vec3, 11> points;
    Quaternion from;

    Place at(std::size_t i, const Rational& s) const {
        const Place p = place_of(points[i]), c = place_of(points[6]), to = place_of(points[7]);
        if (i >= 3) {
            const Place way = place_of(points[9]) - place_of(points[8]);
            return {p[0] + s * way[0], p[1] + s * way[1], p[2] + s * way[2]};
        }
        const auto part = [&](const Rational& first, double last) -> Rational { return (1 - s) * first + s * last; };
        const Rational a = part(from.w, w);
        const Place b = {part(from.x, v[0]), part(from.y, v[1]), part(from.z, v[2])};
        const Place g = p - place_of(points[10]), once = cross_of(b, g);
        const Rational norm = a * a + dot_of(b, b), beside = 2 * dot_of(b, g), of_g = a * a - dot_of(b, b);
        Place x;
        for (std::size_t k = 0; k < 3; ++k) {
            x[k] = c[k] + s * (to[k] - c[k]) + (of_g * g[k] + beside * b[k] + 2 * a * once[k]) / norm;
        }
        return x;
    }
};

Motion any_motion(scenes::Random& random) {
    const auto number = [&](std::uint32_t most) { return static_cast<double>(random.below(2 * most + 1)) - most; };
    const auto vector = [&] { return Vec3(number(2), number(2), number(2)); };
    Motion motion{number(3) / 2, vector(), {}, {}};
    if (motion.v.isZero()) motion.w = 1.5;
    if (random.below(8) == 0) motion.v = Vec3(0, 0, 1);
    for (Vec3& point : motion.points) point = vector();
    if (random.below(3) == 0) motion.points[7] = motion.points[6];
    if (random.below(2) == 0) motion.points[9] = motion.points[8];
    if (random.below(2) == 0) {
        motion.points[10] = motion.points[6];
    } else {
        motion.from = {number(3), number(3), number(3), 0.5};
        motion.v[2] = std::abs(motion.v[2]);  // so that neither is a negative multiple of the other
    }
    return motion;
}

TEST(TurningTriangles, SignsAreThoseOfRationalPlaces) {
    scenes::Random random(42);
    const Pose world;
    for (int run = 0; run < 60; ++run) {
        const Motion motion = any_motion(random);
        PosedPoints<11> points;
        for (std::size_t i = 0; i < 11; ++i) points[i] = {&world, &motion.points[i]};
        const TurnIntegers turn(motion.from, {motion.w, motion.v[0], motion.v[1], motion.v[2]});
        with_integers(points, [&](const auto& integers) {
            TurningTriangles triangles(integers, turn);
            for (int time = 0; time <= 8; ++time) {
                const BinaryFraction s{Integer(std::int64_t{time}), 3};
                std::array<Place, 6> x;
                for (std::size_t i = 0; i < 6; ++i) x[i] = motion.at(i, Rational(time) / 8);
                const auto expect = [&](const Polynomial& p, const Rational& value) {
                    EXPECT_LE(p.degree(), 3);
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
}

}  // namespace
}  // namespace ecods::exact::turning_triangles_test
