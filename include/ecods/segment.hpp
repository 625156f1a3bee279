// Line segments and rays, and the boxes that segments meet.
#pragma once

#include <limits>

#include "ecods/aabb.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// The closed segment of the points between two ends, which may be one point. Ends are finite.
struct Segment {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
};

// The points origin + s * direction for all real s from 0 to the largest parameter, both included. The direction is not
// zero, and of any length: parameters are in units of it as it is given. Without end by default.
struct Ray {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = Vec3::UnitX();
    double parameter_max = std::numeric_limits<double>::infinity();
};

// Whether the closed segment and the closed box share a point, for the real numbers that the doubles are: exact in any
// rounding mode. Sides of the box may be infinite. An end that is not finite makes the answer meaningless.
ECODS_API bool overlap(const Segment& segment, const Aabb& box) noexcept;

// Throws InvalidArgument if a coordinate of an end is not finite.
ECODS_API void validate(const Segment& segment);

// Throws InvalidArgument if a coordinate of the origin or the direction is not finite, the direction is zero, or the
// largest parameter is negative or NaN.
ECODS_API void validate(const Ray& ray);

}  // namespace ecods
