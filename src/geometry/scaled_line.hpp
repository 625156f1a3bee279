// A ScaledLine is a line whose direction is scaled to a moderate size and rounded to doubles, for floating-point
// filters.
#pragma once

#include "geometry/line.hpp"

namespace ecods {

// Holds the points a + s d, where d is the line's direction divided by 2^exponent. A parameter s here is the line's own
// parameter times 2^exponent. The exponent depends on the line alone, so parameters of hits on different bodies can be
// compared.
struct ScaledLine {
    explicit ScaledLine(const Line& line) noexcept;

    // scaled_above() converts a parameter of the line to this line's scaled parameter, unscaled_above() converts back.
    // Both return an upper bound of the converted number.
    double scaled_above(double parameter) const noexcept;
    double unscaled_above(double parameter) const noexcept;

    Vec3 a;
    Vec3 d = Vec3::Zero();        // rounded; the largest |coordinate| is from 1 to 4 if is_known
    Vec3 d_error = Vec3::Zero();  // upper bound of |d - exact direction|, by axis
    int exponent = 0;
    double end_low = 0, end_high = 0;  // lower and upper bound of the scaled end
    bool is_known = true;              // false if the direction is too short to be scaled in doubles
    bool is_point = false;             // true if d is zero
};

}  // namespace ecods
