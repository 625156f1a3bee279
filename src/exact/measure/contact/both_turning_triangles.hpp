// BothTurningTriangles computes the relative position of two triangles that turn, each by a turn of its own, as
// polynomials in time.
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
#pragma once

#include <array>
#include <optional>

#include "exact/measure/contact/relative_position.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

class BothTurningTriangles final : public RelativePositionOf<Quintic> {
  public:
    // Takes the corners of both triangles; the places of the first one's pivot at time 0 and 1, and those of the second
    // one's.
    template <class Kernel>
    BothTurningTriangles(const IntegerPoints<Kernel, 10>& points, const TurnIntegers& turn_a,
                         const TurnIntegers& turn_b) {
        const auto at = [&](std::size_t i) -> LongVector3 {
            const auto& p = points.at[i];
            return {Integer(p[0]), Integer(p[1]), Integer(p[2])};
        };
        set(0, {at(0), at(1), at(2)}, at(6), at(7), turn_a);
        set(1, {at(3), at(4), at(5)}, at(8), at(9), turn_b);
    }

    Quintic difference(std::size_t i, std::size_t j, std::size_t axis) const override;
    const Vector& turn(const CornerAndEdge& which) override;
    Quintic corner_volume(std::size_t side, std::size_t corner) override;
    Quintic edge_volume(std::size_t edge_a, std::size_t edge_b) const override;

  private:
    // Holds the homogeneous coordinates of a triangle's corners, edges and plane.
    struct Side {
        Quintic norm;
        std::array<Vector, 3> corner, edge, moment;
        Vector normal;
        Quintic offset;
    };

    void set(std::size_t side, const std::array<LongVector3, 3>& corners, const LongVector3& pivot,
             const LongVector3& pivot_to, const TurnIntegers& turn);

    std::array<Side, 2> sides_;
    std::array<std::optional<Vector>, 18> turns_;
};

}  // namespace ecods::exact
