// Compares the distance of two points or segments with a number, in doubles with proven bounds. Most pairs of spheres
// and capsules are decided so, without their trees.
#pragma once

#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// True if the body is a point, or a segment whose mesh names its second end twice.
bool is_segment(const MeshShape& shape) noexcept;

// Returns the sign of the distance of the segments less the sum of x, y and z, which are finite and not negative;
// nullopt if doubles do not decide. Never returns 0. Cost: some tens of nanoseconds.
std::optional<int> compare_segments(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double x, double y,
                                    double z) noexcept;

}  // namespace ecods
