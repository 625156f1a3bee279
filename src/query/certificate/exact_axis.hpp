// Axes that two triangles give, in integers, and which of them prove that the triangles are apart.
#pragma once

#include <optional>

#include "query/certificate/axis_formula.hpp"
#include "query/certificate/exact_points.hpp"

namespace ecods {

// From where to where a triangle reaches along n.
struct ExactReach {
    exact::Integer low, high;
};
ExactReach reach_of(const IntegerVector3& n, const IntegerVector3* corners);

// What is apart, besides being on two sides: the claims touching and hit.
enum class ApartBy : std::uint8_t {
    weakly,     // not on the inner sides of each other: gap >= 0
    strictly,   // gap > 0
    half_open,  // corner 3 strictly on the other side of a's triangle, and corners 4 and 5 weakly
};

// The first of the 32 axes of verify/certificates/README.md along which the triangles are apart; they are complete: if
// there is none, triangles cross (weakly), meet (strictly), or a's meets the segment before its end (half_open).
std::optional<AxisFormula> find_axis(const SixCorners& corners, ApartBy apart);
// Whether they are apart along this one.
bool is_axis(const AxisFormula& formula, const SixCorners& corners, ApartBy apart);

}  // namespace ecods
