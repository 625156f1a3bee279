// Detects that a line begins inside a solid, and makes the hit at the line's beginning.
#pragma once

#include "ecods/ask.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "query/body/posed_body.hpp"

namespace ecods {

inline const Vec3& begin_of(const Segment& segment) noexcept {
    return segment.a;
}
inline const Vec3& begin_of(const Ray& ray) noexcept {
    return ray.origin;
}

// Returns true if the point is inside the solid, and not on its surface. The work is counted as part of the question
// that calls this function.
bool is_inside(const Vec3& point, const PosedBody& body, QueryMemory& memory);

// Returns the hit at `begin`, the beginning of a line inside a solid.
Hit hit_inside(const Vec3& begin) noexcept;

}  // namespace ecods
