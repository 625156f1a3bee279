// A ScaledLine is a line in doubles whose direction has a moderate size, for filters.
#pragma once

#include "geometry/line.hpp"

namespace ecods {

// Holds the points a + s d, where d is the line's direction divided by 2^exponent. Parameters are the line's times
// 2^exponent. They depend on the line alone, so hits on different bodies can be compared.
struct ScaledLine {
    explicit ScaledLine(const Line& line) noexcept;

    // Return upper bounds of a parameter after, and before, scaling.
    double scaled_above(double parameter) const noexcept;
    double unscaled_above(double parameter) const noexcept;

    Vec3 a;
    Vec3 d = Vec3::Zero();        // rounded: the largest coordinate is from 1 to 4, if the direction is known
    Vec3 d_error = Vec3::Zero();  // |d - exact|, by axis
    int exponent = 0;
    double end_low = 0, end_high = 0;  // bounds of the scaled end
    bool is_known = true;              // false if the direction is too short for doubles
    bool is_point = false;             // true if d is zero
};

}  // namespace ecods
