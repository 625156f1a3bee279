// RelativePosition describes the position of two moving triangles relative to each other, by polynomials in time. The
// decision of a first meeting (first_meeting.hpp) needs nothing else of a motion.
#pragma once

#include <array>
#include <cstddef>

#include "exact/number/polynomial.hpp"

namespace ecods::exact {

// CornerAndEdge names corner `corner` of triangle `side`, and the edge of the other triangle that begins at corner
// `edge`. The first triangle is side 0.
struct CornerAndEdge {
    std::size_t side;  // triangle of the corner
    std::size_t corner;
    std::size_t edge;
};

constexpr std::size_t index_of(const CornerAndEdge& which) noexcept {
    return 9 * which.side + 3 * which.corner + which.edge;
}

// RelativePositionOf gives, by each function, the polynomial of a number that the function's comment names, times a
// factor. The factor depends only on the time, and is positive at all times from 0 to 1. All turns have one factor, all
// volumes another, and all differences a third. P is the type of the polynomials, for their greatest degree.
template <class P>
class RelativePositionOf {
  public:
    using Vector = std::array<P, 3>;

    virtual ~RelativePositionOf() = default;

    // Returns coordinate `axis` of the difference (corner i of the first triangle) - (corner j of the second triangle).
    virtual P difference(std::size_t i, std::size_t j, std::size_t axis) const = 0;
    // Returns (q - p) x (c - p) for the edge from p to q and the corner c. It is zero if and only if c is on the line
    // of the edge, or p = q. The result is cached.
    virtual const Vector& turn(const CornerAndEdge& which) = 0;
    // Return six times the signed volume of four corners: a corner and the other triangle, or an edge of each triangle.
    // The volume is zero if and only if the four corners are in one plane.
    virtual P corner_volume(std::size_t side, std::size_t corner) = 0;
    virtual P edge_volume(std::size_t edge_a, std::size_t edge_b) const = 0;
};

using RelativePosition = RelativePositionOf<Polynomial>;

}  // namespace ecods::exact
