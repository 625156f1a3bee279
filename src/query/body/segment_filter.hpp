// Compares the distance of two points or segments with a number, in doubles with proven bounds. This comparison decides
// most pairs of spheres and capsules without their trees.
#pragma once

#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns true if the body is a point, or a segment whose mesh names its second end twice.
bool is_segment(const MeshShape& shape) noexcept;

// Returns the sign of (distance of the segments - (x + y + z)); nullopt if doubles do not decide. x, y and z must be
// finite and not negative. Never returns 0. Cost: some tens of nanoseconds.
std::optional<int> compare_segments(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double x, double y,
                                    double z) noexcept;

}  // namespace ecods
