// first_meeting computes exactly the first time at which two moving triangles share a point.
#pragma once

#include <optional>

#include "exact/measure/contact/moving_triangles.hpp"
#include "exact/measure/contact/possible_features.hpp"

namespace ecods::exact {

struct Meeting {
    double time;           // the exact time, rounded once
    bool is_late;          // true if the exact time is above `time`
    FeaturePair features;  // the first pair, in the order of feature_pairs, that shares a point at the exact time
};

// Returns the first meeting in [0, 1]; nullopt if there is none. The triangles must not share a point at time 0.
std::optional<Meeting> first_meeting(MovingTriangles& triangles);

// An interval of time, from m / 2^bits to (m + count) / 2^bits, which is at most 1.
struct TimeCells {
    std::int64_t m;
    int bits, count;

    TimeSpan span() const noexcept;
};
// Returns cells that contain `time`. Their length is at most four times the length of `time`, or 2^-43 of its end if
// that is longer. Returns nullopt if the cells would be longer than short_time, or if `time` is very close to 0.
std::optional<TimeCells> cells_around(const TimeSpan& time) noexcept;

struct PartialAnswer {
    bool is_known;
    std::optional<Meeting> meeting;
};

// Finds the first meeting before the end of the cells. The triangles must share no point up to the beginning of the
// cells, and in the cells only pairs of `features` may share points. If a cell contains several candidates, is_known is
// false in the result.
PartialAnswer first_meeting_in(MovingTriangles& triangles, const TimeCells& cells, FeatureSet features);

}  // namespace ecods::exact
