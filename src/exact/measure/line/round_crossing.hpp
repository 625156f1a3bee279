// round_crossing rounds the point in which a line crosses a triangle's face, once, from leading digits if they suffice.
#pragma once

#include <array>

#include "ecods/pose.hpp"
#include "exact/measure/round/fraction.hpp"
#include "exact/number/kernel.hpp"

namespace ecods::exact {

// Holds a line's beginning, in world coordinates, and its direction in units of 2^unit. The corners of a triangle that
// go with it are relative to the beginning, in the same units.
struct LineInUnits {
    Vec3 from;
    TwoLimbKernel::Point direction;
    int unit = 0;
};

// Holds the crossing's parameter and point, rounded like round_on_line(), and the sign of n . d as in line_hit.hpp.
struct RoundedCrossing {
    RoundedOnLine at;
    int facing = 0;
};

// Sets `result` and returns true; or returns false if leading digits leave a rounding open, as for numbers half-way
// between two doubles. The caller must know that the line crosses the triangle's plane, at a positive parameter. Uses
// integers alone: the floating-point environment has no effect. Cost: a third of the exact fraction and its rounding.
bool round_crossing(const LineInUnits& line, const std::array<TwoLimbKernel::Point, 3>& corners,
                    RoundedCrossing& result) noexcept;

}  // namespace ecods::exact
