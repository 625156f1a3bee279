// round_crossing computes the point in which a line crosses a triangle's face, rounded once, from leading digits if
// these suffice.
#pragma once

#include <array>

#include "ecods/pose.hpp"
#include "exact/measure/round/fraction.hpp"
#include "exact/number/kernel.hpp"

namespace ecods::exact {

// LineInUnits has the beginning `from` of the line in world coordinates, and `direction` in units of 2^unit. The
// corners of triangles are given relative to `from`, in the same units.
struct LineInUnits {
    Vec3 from;
    TwoLimbKernel::Point direction;
    int unit = 0;
};

// A RoundedCrossing has in `at` the crossing's parameter and point, rounded as by round_on_line(). `facing` is the sign
// of n . d, as in line_hit.hpp.
struct RoundedCrossing {
    RoundedOnLine at;
    int facing = 0;
};

// Sets `result` to the crossing of the line and the triangle with these corners, and returns true. Returns false if
// leading digits do not determine the rounding, for example of numbers half-way between two doubles. The line must
// cross the triangle's plane, at a positive parameter. The floating-point environment has no effect, because only
// integers are used. Cost: a third of the exact fraction and its rounding.
bool round_crossing(const LineInUnits& line, const std::array<TwoLimbKernel::Point, 3>& corners,
                    RoundedCrossing& result) noexcept;

}  // namespace ecods::exact
