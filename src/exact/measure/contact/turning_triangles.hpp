// TurningTriangles computes the relative position of a triangle that turns and one that is at rest or translated, as
// polynomials in time. Beside a body that is translated, the pivot goes back by as much, and that body is at rest.
//
// A point p of the first triangle is at c + s m + Q(s) g / N(s) at time s, with g = p - c, the pivot c and its way m.
// With the quaternion (w, v), let E, W and V be 1, w and v in a unit in which all of them are integers, and U = W - E.
// The quaternion at time s is (E + s U, s V). Its square of length, which is positive from time 0 to 1, is
//     N = E^2 + 2 E U s + (U^2 + V.V) s^2,
// and its rotation times N, for any vector g, is
//     Q g = N g + s q1(g) + s^2 q2(g),   q1(g) = 2 E (V x g),   q2(g) = 2 (U (V x g) + V x (V x g)).
// To see it, let a = E + s U and b = s V: Q g = (a^2 - b.b) g + 2 (b.g) b + 2 a b x g, where N = a^2 + b.b and
// b x (b x g) = (b.g) b - (b.b) g; so Q g = N g + 2 a b x g + 2 b x (b x g).
//
// Rotations keep dot products, and turn cross products: Q a . Q b = N^2 a.b and Q a x Q b = N Q (a x b). So everything
// that is asked is a polynomial over N, of degree 3 at most:
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

// The numbers E, U, V and the coefficients of N.
struct TurnIntegers {
    // The vectors q1(g) and q2(g) of a vector g.
    struct Turned {
        LongVector3 first, second;
    };

    TurnIntegers(double w, const Vec3& v);

    Turned turned(const LongVector3& g) const;

    Integer e, u;
    LongVector3 v;
    LongVector3 n;
};

class TurningTriangles final : public RelativePosition {
  public:
    // Takes the corners of the triangle that turns, then those of the other one; the places of the pivot at time 0 and
    // 1; and both ends of the vector by which the other triangle is translated. `turn` must outlive this object.
    template <class Kernel>
    TurningTriangles(const IntegerPoints<Kernel, 10>& points, const TurnIntegers& turn) : turn_(turn) {
        const auto at = [&](std::size_t i) -> LongVector3 {
            const auto& p = points.at[i];
            return {Integer(p[0]), Integer(p[1]), Integer(p[2])};
        };
        set({at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9)});
    }

    Polynomial difference(std::size_t i, std::size_t j, std::size_t axis) const override;
    const Vector& turn(const CornerAndEdge& which) override;
    Polynomial corner_volume(std::size_t side, std::size_t corner) override;
    Polynomial edge_volume(std::size_t edge_a, std::size_t edge_b) const override;

  private:
    using Turned = TurnIntegers::Turned;
    // The coefficients of a vector beside N times start + s way, of s, s^2 and s^3.
    struct Rest {
        LongVector3 first, second, third = {};
    };

    void set(const std::array<LongVector3, 10>& points);
    Polynomial over_norm(const Integer& start, const Integer& way, const Integer& first, const Integer& second,
                         const Integer& third) const;
    Vector over_norm(const LongVector3& start, const LongVector3& way, const Rest& rest) const;
    Vector turn_of_turning(std::size_t corner, std::size_t edge) const;
    Vector turn_of_resting(std::size_t corner, std::size_t edge) const;

    const TurnIntegers& turn_;
    std::array<LongVector3, 3> p_, y_;  // corners at time 0
    std::array<LongVector3, 3> r_;      // y - c
    std::array<LongVector3, 3> turning_edge_, resting_edge_;
    LongVector3 m_;
    std::array<Turned, 3> turned_corner_, turned_edge_;
    std::array<Turned, 3> turned_moment_;  // of (edge) x (its first corner - c)
    std::array<std::optional<Vector>, 18> turns_;
};

}  // namespace ecods::exact
