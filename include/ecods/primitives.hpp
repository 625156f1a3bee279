// Primitives are boxes, segments, rays and balls, and the tests of whether they overlap. All answers are exact for the
// real numbers that the doubles represent, in any rounding mode.
//
// Example: verify/examples/how_do_i, overlap_of_boxes().
#pragma once

#include <limits>

#include "ecods/export.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// An Aabb is an axis-aligned box: the points p with min <= p <= max (FCL, Coal: AABB; Parry: Aabb; Jolt: AABox).
// Extents may be zero; ends may be infinite, for bounds that are not finite. No number may be NaN, and min may not
// exceed max.
struct Aabb {
    Vec3 min = Vec3::Zero();
    Vec3 max = Vec3::Zero();

    friend bool operator==(const Aabb& a, const Aabb& b) { return a.min == b.min && a.max == b.max; }
};

// A Segment is the set of points between two ends, ends included. The ends must be finite, and may be equal.
struct Segment {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
};

// A Ray is the set of points origin + s * direction for all real s from 0 to `max_parameter`, both included. The
// direction must not be zero, and may have any length: parameters are multiples of the direction as given. By default,
// a ray has no end.
struct Ray {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = Vec3::UnitX();
    double max_parameter = std::numeric_limits<double>::infinity();
};

// A Ball is the set of points whose distance from the center is at most the radius. The center must be finite. With
// radius zero it is one point; with an infinite radius it contains everything, points at infinity included.
struct Ball {
    Vec3 center = Vec3::Zero();
    double radius = 0;
};

// Return true if the closed sets share a point. Ends of a box may be infinite. If validate() refuses an argument, the
// answer has no meaning.
[[nodiscard]] ECODS_API bool overlap(const Aabb& a, const Aabb& b) noexcept;
[[nodiscard]] ECODS_API bool overlap(const Segment& segment, const Aabb& box) noexcept;
[[nodiscard]] ECODS_API bool overlap(const Ball& ball, const Aabb& box) noexcept;

// Returns true if `inner` is a subset of `outer`.
[[nodiscard]] ECODS_API bool contains(const Aabb& outer, const Aabb& inner) noexcept;

// Returns the smallest box that contains both.
[[nodiscard]] ECODS_API Aabb merge(const Aabb& a, const Aabb& b) noexcept;

// Returns a box that contains the exact posed mesh. Let u = 2^-53, and let v_max hold, for each axis, the largest
// magnitude of the mesh's coordinates. Each side exceeds that of the tightest box by at most the largest coordinate of
// 21 u (|R| v_max + |t|); or by one double, if these are subnormal. An end is infinite only if it is beyond the largest
// double, whatever the other ends are. Cost: one pass over the vertices in use.
[[nodiscard]] ECODS_API Aabb box_of(const Mesh& mesh, const Pose& pose);

// Throw InvalidArgument. A box must have no NaN and no min above max on an axis; the ends of a segment must be finite;
// a ray must have a finite origin, a finite direction that is not zero, and a largest parameter that is neither
// negative nor NaN; a ball must have a finite center, and a radius that is neither negative nor NaN.
ECODS_API void validate(const Aabb& box);
ECODS_API void validate(const Segment& segment);
ECODS_API void validate(const Ray& ray);
ECODS_API void validate(const Ball& ball);

}  // namespace ecods
