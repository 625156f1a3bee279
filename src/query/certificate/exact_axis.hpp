// Finds an axis, in integers, that proves two triangles to be apart.
#pragma once

#include <optional>

#include "query/certificate/axis_formula.hpp"
#include "query/certificate/exact_points.hpp"

namespace ecods {

// The interval of a triangle along n.
struct ExactReach {
    exact::Integer low, high;
};
ExactReach reach_of(const IntegerVector3& n, const IntegerVector3* corners);

// Says how two triangles must be apart along an axis. The claims touching and hit need weakly and half_open.
enum class ApartBy : std::uint8_t {
    weakly,     // gap >= 0: they are on different sides, and may touch
    strictly,   // gap > 0
    half_open,  // corner 3 strictly on the other side of a's triangle, corners 4 and 5 weakly
};

// The first of the 32 axes of verify/certificates/README.md along which the triangles are apart. The list is complete:
// if there is none, the triangles cross (weakly), share a point (strictly), or a's triangle meets the segment before
// its end (half_open).
std::optional<AxisFormula> find_axis(const SixCorners& corners, ApartBy apart);
// True if the triangles are apart along this axis.
bool is_axis(const AxisFormula& formula, const SixCorners& corners, ApartBy apart);

}  // namespace ecods
