// Finds, in integers, an axis that proves two triangles to be apart.
#pragma once

#include <optional>

#include "query/certificate/axis_formula.hpp"
#include "query/certificate/exact_points.hpp"

namespace ecods {

// An ExactReach is the interval that a triangle covers along n: the least and the greatest n . corner.
struct ExactReach {
    exact::Integer low, high;
};
ExactReach reach_of(const exact::LongVector& n, const exact::LongVector* corners);

// ApartBy is the kind of separation that an axis must prove for two triangles. The claim touching needs `weakly`, and
// the claim hit needs `half_open` or `strictly`.
enum class ApartBy : std::uint8_t {
    weakly,     // gap >= 0: the triangles are on different sides, and may touch
    strictly,   // gap > 0
    half_open,  // corner 3 is strictly on one side of a's triangle; corners 4 and 5 are on the same side, or touch
};

// Returns the first of the 32 axes of verify/certificates/README.md that separates the triangles as `apart` requires.
// The list is complete: if no axis separates the triangles, they cross (weakly), share a point (strictly), or a's
// triangle meets the segment before its end (half_open).
std::optional<AxisFormula> find_axis(const SixCorners& corners, ApartBy apart);
// Returns true if the axis of `formula` separates the triangles as `apart` requires.
bool is_axis(const AxisFormula& formula, const SixCorners& corners, ApartBy apart);

}  // namespace ecods
