// An IntegerPair holds the corners of two triangles as integers, for guesses of features and for enclosures.
#pragma once

#include <array>

#include "exact/point/integer_frame.hpp"
#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// An IntegerPair holds the three corners of the first triangle and then of the second, in units of 2^unit. Each
// coordinate of the difference of two corners is off by less than `error` units (by 0 if `error` is 0).
struct IntegerPair {
    std::array<IntegerFrame::Point, 6> at;
    int unit;
    int error;                    // 0 if exact, or IntegerFrame::error_units
    bool first_is_point = false;  // true if the first three corners are equal: a point
};

// Returns the corners of triangle a of the frame's first body and triangle b of its second body.
ECODS_ALWAYS_INLINE IntegerPair integer_pair(IntegerFrame& frame, const Triangle& a, const Triangle& b) noexcept {
    IntegerPair pair;
    for (std::size_t k = 0; k < 3; ++k) {
        pair.at[k] = frame.at(0, a[k]);
        pair.at[3 + k] = frame.at(1, b[k]);
    }
    pair.unit = frame.unit();
    pair.error = frame.error();
    return pair;
}

// Returns the points minus the first point as doubles, scaled by one power of two, so that magnitudes are below 2^53.
Points<6> to_doubles(const IntegerPair& pair) noexcept;

// Returns the corner at which the two shorter edges of the triangle meet: the cross product of these edges is the most
// accurate one.
std::size_t blunt_corner(const IntegerPair& pair, std::size_t side) noexcept;

}  // namespace ecods::exact
