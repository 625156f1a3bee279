// Two numbers between which the distance of two triangles is, from one guessed pair of features.
#pragma once

#include <array>
#include <limits>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/fixed_points.hpp"
#include "exact/point/point.hpp"

namespace ecods::exact {

struct Enclosure {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
    // Whether the features certainly hold the only closest points, each in its relative interior.
    bool is_certain = false;
};

// Six integer points in units of 2^unit, each coordinate of a difference off by less than `error` units.
struct IntegerPair {
    std::array<FixedPoints::Point, 6> at;
    int unit;
    int error;  // 0: exact, or FixedPoints::error_units
};

// Whatever the features are, the interval contains the distance; it is narrow if they are the closest. In any rounding
// mode, with or without flush-to-zero or fused multiply-add.
Enclosure enclose_distance(const IntegerPair& pair, const FeaturePair& features) noexcept;

// The corner of a face from which its two shorter edges go: their product is the most accurate one.
std::size_t blunt_corner(const IntegerPair& pair, std::size_t side) noexcept;

// The points less the first one, in a common power of two, below 2^53.
Points<6> to_doubles(const IntegerPair& pair) noexcept;

// A guess for such points.
FeaturePair guess_features(const IntegerPair& pair) noexcept;

}  // namespace ecods::exact
