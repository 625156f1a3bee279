// Segments and balls against boxes, in rationals.
#pragma once

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods::oracle {

// Whether the closed segment and the closed box share a point. The ends are finite; sides of the box may be infinite.
bool segment_meets_box(const Vec3& a, const Vec3& b, const Aabb& box);

// Whether a point of the closed box is at most the radius away from the center, which is finite.
bool ball_meets_box(const Vec3& center, double radius, const Aabb& box);

}  // namespace ecods::oracle
