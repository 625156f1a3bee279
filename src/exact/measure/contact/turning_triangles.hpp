// TurningTriangles computes the relative position of a triangle that turns and a triangle that is at rest or
// translated, as polynomials in time. A translation of the second body is subtracted from the way of the pivot, so that
// the second body is at rest.
//
// A point p of the first triangle is at c + s m + Q(s) g / N(s) at time s, with g = p - c, the pivot c and its way m.
// The quaternion moves straight from one quaternion to another: in a unit in which all components of both are integers,
// it is (E + s U, F + s V). The square of its length, which is positive from time 0 to 1, is
//     N = E^2 + F.F + 2 (E U + F.V) s + (U^2 + V.V) s^2,
// and its rotation times N, for any vector g, is
//     Q g = N g + q0 g + s q1(g) + s^2 q2(g),   where
//     q0 g = 2 (E (F x g) + F x (F x g)),   q2(g) = 2 (U (V x g) + V x (V x g)),
//     q1(g) = 2 (E (V x g) + U (F x g) + F x (V x g) + V x (F x g)).
// To see it, let a = E + s U and b = F + s V: Q g = (a^2 - b.b) g + 2 (b.g) b + 2 a b x g, where N = a^2 + b.b and
// b x (b x g) = (b.g) b - (b.b) g; so Q g = N g + 2 a b x g + 2 b x (b x g). A Turn has E = 1 and F = 0 in this unit,
// so q0 is zero. A leg of a Way begins at any quaternion: p is then where the corner would be had the body gone from
// its start to the beginning of the leg without turning, so that g and all widths are those of the start.
//
// Rotations keep dot products, and turn cross products: Q a . Q b = N^2 a.b and Q a x Q b = N Q (a x b). So each number
// of RelativePosition is one of these polynomials, of degree 3 at most, divided by N. (If q0 is not zero, each term s
// q1 has one of q0 beside it, without the factor s.)
//
//   p - y of a corner p and one of the other triangle, y:  N (p - y + s m) + s q1(g) + s^2 q2(g)
//   volume of p and the face at rest, with the normal n and a corner y:   the same, times n
//   volume of y and the face that turns, with the normal n and a corner p, r = y - c:
//       N n.(y - p - s m) + s q1(n).(r - s m) + s^2 q2(n).(r - s m)
//   volume of the edge a that turns, from p, and b at rest, from y, h = g x a:
//       N a.(b x (y - p - s m)) + s (q1(a).(b x (r - s m)) - b.q1(h)) + s^2 (q2(a).(b x (r - s m)) - b.q2(h))
//   turn of p about the edge b from y:    N b x (p - y + s m) + s b x q1(g) + s^2 b x q2(g)
//   turn of y about the edge a from p, h = a x g:
//       N a x (y - p - s m) + s (q1(a) x (r - s m) - q1(h)) + s^2 (q2(a) x (r - s m) - q2(h))
//
// For example, the second volume is Q n . (y - x) / N with x = c + s m + Q g / N and Q n . Q g = N^2 n.g, that is
// Q n.(r - s m) - N n.g; with Q n = N n + ... and r - g = y - p this is the formula.
#pragma once

#include <array>
#include <optional>

#include "exact/measure/contact/relative_position.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

using LongVector3 = std::array<Integer, 3>;

// TurnIntegers holds the numbers E, U, F, V and the coefficients of N.
struct TurnIntegers {
    // Turned holds the vectors q0 g, q1(g) and q2(g) of a vector g.
    struct Turned {
        LongVector3 zeroth, first, second;
    };

    // The constructors take a turn from the quaternion 1 to (w, v), or a turn from one quaternion to another.
    TurnIntegers(double w, const Vec3& v);
    TurnIntegers(const Quaternion& from, const Quaternion& to);

    Turned turned(const LongVector3& g) const;

    Integer e, u;
    LongVector3 f, v;
    LongVector3 n;
};

class TurningTriangles final : public RelativePosition {
  public:
    static constexpr std::size_t point_count = 11;

    // Takes the corners of the triangle that turns, at the start of its way, and the corners of the other triangle;
    // then the places of the pivot at time 0 and 1; both ends of the vector by which the other triangle is translated;
    // and the place of the pivot at the start of the way. Ignores later points. `turn` must outlive this object.
    template <class Kernel, std::size_t N>
    requires(N >= point_count) TurningTriangles(const IntegerPoints<Kernel, N>& points, const TurnIntegers& turn)
        : turn_(turn) {
        std::array<LongVector3, point_count> all;
        for (std::size_t i = 0; i < point_count; ++i) {
            const auto& p = points.at[i];
            all[i] = {Integer(p[0]), Integer(p[1]), Integer(p[2])};
        }
        set(all);
    }

    Polynomial difference(std::size_t i, std::size_t j, std::size_t axis) const override;
    const Vector& turn(const CornerAndEdge& which) override;
    Polynomial corner_volume(std::size_t side, std::size_t corner) override;
    Polynomial edge_volume(std::size_t edge_a, std::size_t edge_b) const override;

  private:
    using Turned = TurnIntegers::Turned;
    // Beside holds the coefficients of 1, s, s^2 and s^3 of a number, or a vector, that is added to N (start + s way).
    template <class T>
    struct Beside {
        T zeroth, first, second, third = {};
    };
    using Rest = Beside<LongVector3>;

    void set(const std::array<LongVector3, point_count>& points);
    Polynomial over_norm(const Integer& start, const Integer& way, const Beside<Integer>& rest) const;
    Vector over_norm(const LongVector3& start, const LongVector3& way, const Rest& rest) const;
    Vector turn_of_turning(std::size_t corner, std::size_t edge) const;
    Vector turn_of_resting(std::size_t corner, std::size_t edge) const;

    const TurnIntegers& turn_;
    std::array<LongVector3, 3> p_, y_;  // corners at time 0, p_ without the turn up to then
    std::array<LongVector3, 3> r_;      // y - c
    std::array<LongVector3, 3> turning_edge_, resting_edge_;
    LongVector3 m_;
    std::array<Turned, 3> turned_corner_, turned_edge_;
    std::array<Turned, 3> turned_moment_;  // of (edge) x (its first corner - c)
    std::array<std::optional<Vector>, 18> turns_;
};

}  // namespace ecods::exact
