// An IntegerPair holds the corners of two triangles as integers, for enclosures and guesses of features.
#pragma once

#include <array>

#include "exact/point/integer_frame.hpp"
#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// Holds six integer points in units of 2^unit. A coordinate of a difference of two points is off by less than `error`
// units.
struct IntegerPair {
    std::array<IntegerFrame::Point, 6> at;
    int unit;
    int error;  // 0 if exact, or IntegerFrame::error_units
};

// Reads the corners of one triangle of each of the first two bodies.
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

// Returns the points less the first one, in a common power of two, below 2^53.
Points<6> to_doubles(const IntegerPair& pair) noexcept;

// Returns the corner of a face where its two shorter edges meet: their cross product is the most accurate one.
std::size_t blunt_corner(const IntegerPair& pair, std::size_t side) noexcept;

}  // namespace ecods::exact
