// Line segments, and the boxes that they meet.
#pragma once

#include "ecods/aabb.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// The closed segment of the points between two ends, which may be one point. Ends are finite.
struct Segment {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
};

// Whether the closed segment and the closed box share a point, for the real numbers that the doubles are: exact in any
// rounding mode. Sides of the box may be infinite. An end that is not finite makes the answer meaningless.
ECODS_API bool overlap(const Segment& segment, const Aabb& box) noexcept;

// Throws InvalidSegment if a coordinate of an end is not finite.
ECODS_API void validate(const Segment& segment);

}  // namespace ecods
