// closest_on_segments() computes the closest points of two points or segments in fixed precision, with proven error
// bounds.
#pragma once

#include <array>
#include <optional>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/fixed_vector.hpp"
#include "exact/point/segment_ends.hpp"

namespace ecods::exact {

// A ClosestOnSegments holds the closest points, in the units of SegmentEnds, and bounds of their errors.
struct ClosestOnSegments {
    // `features` is the first pair, in the order of feature_pairs, with closest points in both relative interiors. A
    // segment pq counts as the triangle (p, q, q), whose corners name the features.
    FeaturePair features;
    std::array<IntegerVector, 2> point;
    std::array<ErrorBounds, 2> errors;
    bool is_only = true;  // false if other points may be as close: always, if the segments are parallel
    // Holds upper bounds of the points' parameters, 0 at the first end of a segment and 1 at the second, off by some
    // two_u.
    std::array<double, 2> parameter_max{};

    FixedNumber number(std::size_t side, std::size_t k) const noexcept { return {point[side][k], errors[side][k]}; }
    // Returns the vector from the first closest point to the second; nullopt if the points may be equal.
    std::optional<FixedVector> between() const noexcept {
        return FixedVector::of(difference(point[1], point[0]),
                               {errors[0][0] + errors[1][0], errors[0][1] + errors[1][1], errors[0][2] + errors[1][2]});
    }
};

// Returns the closest points of two segments; nullopt if fixed precision does not decide which features are closest.
// The segments should not meet.
std::optional<ClosestOnSegments> closest_on_segments(const SegmentEnds& ends) noexcept;

}  // namespace ecods::exact
