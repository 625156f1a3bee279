// Balls, and the boxes that they meet.
#pragma once

#include "ecods/aabb.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// The closed ball of the points whose distance from the center is at most the radius. The center is finite. A radius
// of zero is one point; an infinite radius is all there is, points at infinity included.
struct Ball {
    Vec3 center = Vec3::Zero();
    double radius = 0;
};

// Whether the closed ball and the closed box share a point, for the real numbers that the doubles are: exact in any
// rounding mode. Sides of the box may be infinite. What is no ball makes the answer meaningless.
ECODS_API bool overlap(const Ball& ball, const Aabb& box) noexcept;

// Throws InvalidArgument if a coordinate of the center is not finite, or the radius is negative or a NaN.
ECODS_API void validate(const Ball& ball);

}  // namespace ecods
