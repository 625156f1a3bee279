// A line whose direction has a moderate size, in doubles: what filters begin with.
#pragma once

#include "geometry/line.hpp"

namespace ecods {

// The points a + s d, for the d of the line divided by 2^exponent. Its parameters are those of the line times
// 2^exponent: equal lines have equal ones, so they can be compared whatever body they were found at.
struct ScaledLine {
    explicit ScaledLine(const Line& line) noexcept;

    // Upper bounds of the parameter after, and before, scaling.
    double scaled_above(double parameter) const noexcept;
    double unscaled_above(double parameter) const noexcept;

    Vec3 a;
    Vec3 d = Vec3::Zero();        // rounded: the largest coordinate is from 1 to 4, if the direction is known
    Vec3 d_error = Vec3::Zero();  // |d - exact|, by axis
    int exponent = 0;
    double end_low = 0, end_high = 0;  // contain the scaled end
    bool is_known = true;              // false: the direction is so short that doubles say nothing of it
    bool is_point = false;             // d is zero
};

}  // namespace ecods
