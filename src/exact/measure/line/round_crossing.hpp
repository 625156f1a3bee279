// The point in which a line crosses a triangle's face, rounded once: by leading digits, where these say it.
#pragma once

#include <array>

#include "ecods/pose.hpp"
#include "exact/measure/round/fraction.hpp"
#include "exact/number/kernel.hpp"

namespace ecods::exact {

// A line's beginning, its direction and a triangle's corners counted from there, in units of 2^unit.
struct LineInUnits {
    Vec3 from;
    TwoLimbKernel::Point direction;
    int unit = 0;
};

// What round_on_line() says of the point in which the line crosses the triangle, and the sign of n . d as in
// line_hit.hpp.
struct RoundedCrossing {
    RoundedOnLine at;
    int facing = 0;
};

// Sets it and returns true; or returns false where leading digits do not say it, as of numbers half-way between two
// doubles. Only where it is known that the line crosses the triangle's plane, at a positive parameter. Integers alone:
// no floating-point environment shows in it. Cost: a third of that of the exact fraction and its rounding.
bool round_crossing(const LineInUnits& line, const std::array<TwoLimbKernel::Point, 3>& corners,
                    RoundedCrossing& result) noexcept;

}  // namespace ecods::exact
