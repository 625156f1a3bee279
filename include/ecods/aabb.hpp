// Axis-aligned boxes.
#pragma once

#include <Eigen/Core>

#include "ecods/export.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// The closed box of the points p with min <= p <= max. Zero extents are allowed; infinite ones are, too, where a
// bound would not be finite. A box never holds a NaN and never has min above max.
struct Aabb {
    Vec3 min = Vec3::Zero();
    Vec3 max = Vec3::Zero();

    friend bool operator==(const Aabb& a, const Aabb& b) { return a.min == b.min && a.max == b.max; }
};

// Throws InvalidArgument unless min <= max on each axis, which no NaN is.
ECODS_API void validate(const Aabb& box);

// Whether the closed boxes share a point. Exact: comparisons only.
ECODS_API bool overlap(const Aabb& a, const Aabb& b) noexcept;

// Whether `inner` is a subset of `outer`. Exact.
ECODS_API bool contains(const Aabb& outer, const Aabb& inner) noexcept;

// The smallest box that contains both.
ECODS_API Aabb merge(const Aabb& a, const Aabb& b) noexcept;

// A box that contains the exact posed mesh, and exceeds the tightest one on each side by no more than the largest
// coordinate of 21 u (|R| v_max + |t|), where u = 2^-53 and v_max are the largest coordinates in magnitude; by one
// double where these are subnormal. An end is infinite only beyond the largest double, whatever the other ends are.
// Cost: one pass over the vertices in use.
ECODS_API Aabb box_of(const Mesh& mesh, const Pose& pose);

}  // namespace ecods
