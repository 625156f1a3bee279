// possible_features() computes, in doubles and in any rounding mode, which features of two moving triangles may share a
// point in a short interval of time.
//
// During an interval of length w that contains time s, each corner is within w V of its position at s, where V is the
// length of its way from time 0 to 1. So two features are apart during the interval if there is a vector n along which
// the gap of their corners at s exceeds twice the error bound of a projection plus 2 w |n| V. The error bound is
// derived in moving_points.hpp. 2.25 w V is added to it, with V the largest way on an axis as computed. V is off by u'
// V and by twice the error of the positions, which for w <= 2^-20 is below 2^-18 of an error that counts 2.25 times in
// place of 2. The difference of the times and the products are off by some u' of themselves. The excess over 2 covers
// all of this. Vectors are products of at most three differences of corners.
// A corner that turns moves by at most the way that turning_points.hpp bounds, in any direction, and the other triangle
// is at rest: the way is added once, 1.125 times. If both turn, or one turns and one moves straight, the sum of their
// ways is.
// Claim: verify/proofs/lines_and_times.py
#pragma once

#include <array>
#include <cstdint>

#include "exact/measure/contact/both_turning_points.hpp"
#include "exact/measure/contact/moving_points.hpp"
#include "exact/measure/contact/turn_and_straight_points.hpp"
#include "exact/measure/contact/turning_points.hpp"
#include "exact/measure/distance/feature_pair.hpp"

namespace ecods::exact {

// A FeatureSet is a set of pairs of features: bit i stands for feature_pairs[i].
using FeatureSet = std::uint64_t;
inline constexpr FeatureSet all_features = (FeatureSet{1} << feature_pairs.size()) - 1;
inline constexpr double short_time = 0x1p-20;

// A CornerPairs is a set of pairs of corners: bit 3 a + b stands for corner a of the first triangle and corner b of the
// second.
using CornerPairs = std::uint32_t;

// Returns all pairs of a corner of f's first feature and a corner of f's second feature.
constexpr CornerPairs corner_pairs(const FeaturePair& f) noexcept {
    CornerPairs result = 0;
    for (std::size_t i = 0; i < f.corner_count(0); ++i) {
        for (std::size_t j = 0; j < f.corner_count(1); ++j)
            result |= CornerPairs{1} << (3 * ((f.corner(0) + i) % 3) + (f.corner(1) + j) % 3);
    }
    return result;
}

// corners_of_features[i] is corner_pairs(feature_pairs[i]).
inline constexpr std::array<CornerPairs, feature_pairs.size()> corners_of_features = [] {
    std::array<CornerPairs, feature_pairs.size()> result{};
    for (std::size_t k = 0; k < feature_pairs.size(); ++k) result[k] = corner_pairs(feature_pairs[k]);
    return result;
}();

// Returns a set that contains all pairs of closed features that share a point during `time`. `time` must be at most
// short_time long.
FeatureSet possible_features(const MovingPoints& points, const TimeSpan& time) noexcept;
FeatureSet possible_features(const TurningPoints& points, const TimeSpan& time) noexcept;
FeatureSet possible_features(const BothTurningPoints& points, const TimeSpan& time) noexcept;
FeatureSet possible_features(const TurnAndStraightPoints& points, const TimeSpan& time) noexcept;

}  // namespace ecods::exact
