// possible_features says in doubles, in any rounding mode, which features of two moving triangles may share a point in
// a short time.
//
// In a time of length w around s each corner is within w V of its place at s, where V is the length of its way. So
// features are apart all that time if, for some vector n, the gap of their corners at s exceeds twice the bound of a
// projection and 2 w |n| V. The bound is derived in moving_points.hpp; 2.25 w V is added to it, with V the largest way
// on an axis as computed. V is off by u' V and by twice the error of the places, which for w <= 2^-20 is below 2^-18 of
// an error that counts 2.25 times in place of 2; the difference of the times and the products are off by some u' of
// themselves. The excess over 2 covers all of this. Vectors are products of at most three differences of corners.
// Claim: verify/proofs/lines_and_times.py
#pragma once

#include <array>
#include <cstdint>

#include "exact/measure/contact/moving_points.hpp"
#include "exact/measure/distance/feature_pair.hpp"

namespace ecods::exact {

// Has one bit for each of feature_pairs.
using FeatureSet = std::uint64_t;
inline constexpr FeatureSet all_features = (FeatureSet{1} << feature_pairs.size()) - 1;
inline constexpr double short_time = 0x1p-20;

// Holds pairs of corners, one of each triangle: bit 3 a + b.
using CornerPairs = std::uint32_t;

// Returns the pairs of corners that two features have.
constexpr CornerPairs corner_pairs(const FeaturePair& f) noexcept {
    CornerPairs result = 0;
    for (std::size_t i = 0; i < f.corner_count(0); ++i) {
        for (std::size_t j = 0; j < f.corner_count(1); ++j)
            result |= CornerPairs{1} << (3 * ((f.corner(0) + i) % 3) + (f.corner(1) + j) % 3);
    }
    return result;
}

// Lists the corner pairs of each of feature_pairs.
inline constexpr std::array<CornerPairs, feature_pairs.size()> corners_of_features = [] {
    std::array<CornerPairs, feature_pairs.size()> result{};
    for (std::size_t k = 0; k < feature_pairs.size(); ++k) result[k] = corner_pairs(feature_pairs[k]);
    return result;
}();

// Returns a set with all pairs whose closed features share a point in the time. `time` is at most short_time long.
FeatureSet possible_features(const MovingPoints& points, const TimeSpan& time) noexcept;

}  // namespace ecods::exact
