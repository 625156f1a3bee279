// A ShiftedLine is a line that is moved aside by an infinitesimal distance, so that the shifted line meets no edge or
// vertex.
//
// Seen along the line's direction d, a triangle is a polygon. The shifted line crosses the triangle if the line is
// strictly inside the polygon. The parameter of the crossing is infinitely near to the parameter of a point that the
// unshifted line shares with the triangle. For a point p of the line, an edge e from the corner c, and the shift u
// times an infinitesimal, the side of the edge is the sign of
//
//     (d x e) . (p - c),  or if that is 0,  (d x e) . u
//
// The shift is the first u = (1, k, k^2), k = 0, 1, ..., for which no side of an edge is 0 unless d x e is 0. There is
// a first u, because a vector d x e that is not 0 is perpendicular to at most two of the vectors u.
//
// If d x e is 0, or if the triangle is in a plane with the line, the polygon has no inner points, and the line does not
// cross it: the three vectors add up to 0, so their signs are not all equal.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/number/long_vector.hpp"
#include "geometry/line.hpp"
#include "query/hit/exact_hits.hpp"

namespace ecods {

// Returns the exact direction of a line: d of geometry/line.hpp.
exact::ScaledLongVector direction_of(const Line& line);

class ShiftedLine {
  public:
    // Chooses a shift that decides the sides of all edges of the triangles that the line hits.
    ShiftedLine(const Line& line, std::span<const ExactHit> hits, const Posed<MeshShape>& body);

    const Vec3& shift() const noexcept { return shift_; }
    // Returns true if the shifted line crosses the triangle of hit `i`.
    bool crosses(std::size_t i) const noexcept { return crosses_[i] != 0; }

  private:
    Vec3 shift_;
    std::vector<std::uint8_t> crosses_;  // by hit
};

}  // namespace ecods
