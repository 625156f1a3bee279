// BothTurningTriangles computes the relative position of two triangles as polynomials in time. Each triangle turns by a
// turn of its own; or the first one turns, and the corners of the second one move straight.
//
// Names are those of turning_triangles.hpp: at time s a point p of a triangle is at L + Q g / N, with g = p - c, the
// pivot L = c + s m and the norm N, which is positive from time 0 to 1. Rotations keep dot products and turn cross
// products, so homogeneous coordinates of corners, lines and planes are polynomials of degree 3 at most, over N alone:
//     a corner p:                      A = N L + Q g = N (p + s m) + q0 g + s q1(g) + s^2 q2(g)
//     an edge e from p to p + e:       E = Q e,  and its moment  M = E x (A / N) = E x L + Q (e x g)
//     the plane of the normal n at p:  F = Q n,  and its offset  D = F . (A / N) = F . L + N n.g
// (Pluecker coordinates of a line are (E, M).) All of them are divided by N. Let A', N' and so on be the numbers of the
// other triangle. Then each number of RelativePosition is one of these polynomials, of degree 5 at most, divided by N
// N':
//     difference of corners            N' A - N A'
//     volume of a corner and a face    F' . A - N D'
//     volume of two edges              E . M' + E' . M
//     turn of a corner about an edge   E' x A - N M'
//
// A triangle whose corners go straight has N = 1, A and E = A_j - A_i of degree 1, M = E x A and the normal F = E_0 x
// E_1 of degree 2, and D = F . A of degree 3. A triangle that turns has A, M and D of degree 3, and N, E and F of
// degree 2. With one of each, the same formulas give
//     difference of corners                            degree 3
//     volume of a straight corner and a turning face   degree 3
//     volume of a turning corner and a straight face   degree 5
//     volume of two edges                              degree 4
//     turn of a corner about an edge                   degree 3 if the edge turns, 4 if the corner does
//
// Width. Let coordinates be at most 2^n, and 1 and all parts of the quaternion at most 2^m, in their units. Upper
// bounds of coefficients are then 2^(2m + 3) for N, and 2^(2m + k + 5) for the turned vector N g + ... of a vector of
// at most 2^k. If the triangle with primes turns and the other one goes straight, they are 2^(2m + n + 6) for A' and
// E', 2^(2m + 2n + 10) for M', 2^(2m + 2n + 8) for F', 2^(2m + 3n + 13) for D', 2^(n + 2) for E, 2^(2n + 5) for M and
// F, and 2^(3n + 9) for D. Sums of products of three coordinates and three coefficients at most give 2^(2m + 3n + 16)
// for volumes. Integers have as many limbs as that takes.
#pragma once

#include <array>
#include <optional>

#include "exact/measure/contact/relative_position.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

class BothTurningTriangles final : public RelativePositionOf<Quintic> {
  public:
    // Takes the corners of both triangles; then the places of the first triangle's pivot at time 0 and 1, and those of
    // the second triangle's pivot.
    template <class Kernel>
    BothTurningTriangles(const IntegerPoints<Kernel, 10>& points, const TurnIntegers& turn_a,
                         const TurnIntegers& turn_b) {
        const auto at = [&](std::size_t i) { return long_vector(points.at[i]); };
        set(0, {at(0), at(1), at(2)}, at(6), at(7), turn_a);
        set(1, {at(3), at(4), at(5)}, at(8), at(9), turn_b);
    }

    // Takes the corners of both triangles at time 0; the corners at time 1 of the second triangle, which moves
    // straight; and the places of the first triangle's pivot at time 0 and 1.
    template <class Kernel>
    BothTurningTriangles(const IntegerPoints<Kernel, 11>& points, const TurnIntegers& turn_a) {
        const auto at = [&](std::size_t i) { return long_vector(points.at[i]); };
        set(0, {at(0), at(1), at(2)}, at(9), at(10), turn_a);
        set_straight(1, {at(3), at(4), at(5)}, {at(6), at(7), at(8)});
    }

    Quintic difference(std::size_t i, std::size_t j, std::size_t axis) const override;
    const Vector& turn(const CornerAndEdge& which) override;
    Quintic corner_volume(std::size_t side, std::size_t corner) override;
    Quintic edge_volume(std::size_t edge_a, std::size_t edge_b) const override;

  private:
    // A Side holds the homogeneous coordinates of a triangle's corners, edges and plane.
    struct Side {
        Quintic norm;
        std::array<Vector, 3> corner, edge, moment;
        Vector normal;
        Quintic offset;
    };

    template <class Point>
    static LongVector3 long_vector(const Point& p) {
        return {Integer(p[0]), Integer(p[1]), Integer(p[2])};
    }

    void set(std::size_t side, const std::array<LongVector3, 3>& corners, const LongVector3& pivot,
             const LongVector3& pivot_to, const TurnIntegers& turn);
    void set_straight(std::size_t side, const std::array<LongVector3, 3>& from, const std::array<LongVector3, 3>& to);

    std::array<Side, 2> sides_;
    std::array<std::optional<Vector>, 18> turns_;
};

}  // namespace ecods::exact
