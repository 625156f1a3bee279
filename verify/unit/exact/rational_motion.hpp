// Triangles that turn, or go straight, at rational times, for tests of turns.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "exact/measure/contact/both_turning_triangles.hpp"
#include "scenes/random.hpp"
#include "unit/exact/rational_place.hpp"

namespace ecods::exact::turns_test {

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
    std::optional<std::array<Vec3, 3>> ends = {};  // of the second triangle, if its corners go straight

    std::array<Place, 6> at(const Rational& s) const {
        std::array<Place, 6> x;
        for (std::size_t i = 0; i < 6; ++i) {
            x[i] = turns[i / 3].at(corners[i], s);
            if (i < 3 || !ends) continue;
            const Place from = place_of(corners[i]), way = place_of((*ends)[i - 3]) - from;
            for (std::size_t k = 0; k < 3; ++k) x[i][k] = from[k] + s * way[k];
        }
        return x;
    }

    template <class Use>
    auto with_triangles(Use&& use) const {
        return ends ? with_straight(use) : with_turns(use);
    }

  private:
    template <class Use>
    auto with_straight(Use&& use) const {
        const Pose world;
        PosedPoints<11> points;
        for (std::size_t i = 0; i < 6; ++i) points[i] = {&world, &corners[i]};
        for (std::size_t i = 0; i < 3; ++i) points[6 + i] = {&world, &(*ends)[i]};
        points[9] = {&world, &turns[0].from};
        points[10] = {&world, &turns[0].to};
        const TurnIntegers turn(turns[0].w, turns[0].v);
        return with_integers(points, [&](const auto& integers) {
            BothTurningTriangles triangles(integers, turn);
            return use(triangles);
        });
    }
    template <class Use>
    auto with_turns(Use&& use) const {
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

inline Motion any_motion(scenes::Random& random) {
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
    if (random.below(2) == 0) motion.ends = {vector(), vector(), vector()};
    return motion;
}

}  // namespace ecods::exact::turns_test
