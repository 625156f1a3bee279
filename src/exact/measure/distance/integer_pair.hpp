// The corners of two triangles as integers: what enclosures, and guesses of features, are made from.
#pragma once

#include <array>

#include "exact/measure/round/fixed_points.hpp"
#include "exact/point/point.hpp"

namespace ecods::exact {

// Six integer points in units of 2^unit, each coordinate of a difference off by less than `error` units.
struct IntegerPair {
    std::array<FixedPoints::Point, 6> at;
    int unit;
    int error;  // 0: exact, or FixedPoints::error_units
};

// The points less the first one, in a common power of two, below 2^53.
Points<6> to_doubles(const IntegerPair& pair) noexcept;

// The corner of a face from which its two shorter edges go: their product is the most accurate one.
std::size_t blunt_corner(const IntegerPair& pair, std::size_t side) noexcept;

}  // namespace ecods::exact
