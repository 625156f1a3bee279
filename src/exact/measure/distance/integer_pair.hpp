// The corners of two triangles as integers: what enclosures, and guesses of features, are made from.
#pragma once

#include <array>

#include "exact/point/integer_frame.hpp"
#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// Six integer points in units of 2^unit, each coordinate of a difference off by less than `error` units.
struct IntegerPair {
    std::array<IntegerFrame::Point, 6> at;
    int unit;
    int error;  // 0: exact, or IntegerFrame::error_units
};

// Reads the corners of a triangle of each of the first two bodies.
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

// The points less the first one, in a common power of two, below 2^53.
Points<6> to_doubles(const IntegerPair& pair) noexcept;

// The corner of a face from which its two shorter edges go: their product is the most accurate one.
std::size_t blunt_corner(const IntegerPair& pair, std::size_t side) noexcept;

}  // namespace ecods::exact
