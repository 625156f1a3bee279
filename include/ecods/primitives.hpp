// Primitives are boxes, segments, rays and balls, and the tests of whether they overlap. All answers are exact for the
// real numbers that the doubles represent, in any rounding mode.
//
// Example: verify/examples/how_do_i, overlap_of_boxes().
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <limits>

#include "ecods/export.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"

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

// Returns the smallest box that contains both boxes.
[[nodiscard]] ECODS_API Aabb merge(const Aabb& a, const Aabb& b) noexcept;

// Returns a box that contains the exact posed mesh. Let u = 2^-53, and let v_max hold, for each axis, the largest
// magnitude of the mesh's coordinates. Each side exceeds that of the tightest box by at most the largest coordinate of
// 21 u (|R| v_max + |t|); or by one double, if these are subnormal. An end is infinite only if it is beyond the largest
// double, whatever the other ends are. Cost: one pass over the vertices in use.
[[nodiscard]] ECODS_API Aabb box_of(const Mesh& mesh, const Pose& pose);

// Throw InvalidArgument if the argument is not valid. A box must have no NaN and no min above max on an axis; the ends
// of a segment must be finite; a ray must have a finite origin, a finite direction that is not zero, and a largest
// parameter that is neither negative nor NaN; a ball must have a finite center, and a radius that is neither negative
// nor NaN.
ECODS_API void validate(const Aabb& box);
ECODS_API void validate(const Segment& segment);
ECODS_API void validate(const Ray& ray);
ECODS_API void validate(const Ball& ball);

// ---- exact signs

// Predicates are exact signs of determinants, and the exact relation of two triangles.
//
// A posed point is the real point R v + t; no rounding affects an answer. Every function here is complete: it answers
// for all finite doubles, subnormals and 1e308 included, in every rounding mode, with or without flush-to-zero. The
// caller must see to it that coordinates are finite (Mesh::create and validate(Pose) check this). No function throws or
// allocates. For coordinates so far apart in scale that their integers need thousands of bits, a function uses up to 64
// KiB of stack.
//
// Method: a floating-point filter with a proven bound, then integers of the width that the coordinates really need.
// Names are as in Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997.
//
// Example: verify/examples/how_do_i, exact_signs().

using Vec2 = Eigen::Vector2d;

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

ECODS_API std::ostream& operator<<(std::ostream& out, Sign sign);  // "negative", "zero", "positive"

// A PosedPoint is the point R v + t of a body.
struct PosedPoint {
    Pose pose;
    Vec3 v;
};

// A PosedTriangle is the triangle of a body whose corners are R v + t.
struct PosedTriangle {
    Pose pose;
    std::array<Vec3, 3> corners;
};

// Returns the sign of det(b - a, c - a): positive if a, b, c make a left turn, zero if they are on one line.
ECODS_API Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c) noexcept;

// Returns the sign of det(b - a, c - a, d - a): positive if d is on the side of the plane abc to which (b - a) x (c -
// a) points, zero if the four points are in one plane. (Shewchuk's orient3d has the other sign.)
ECODS_API Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept;

// Return orient2d and orient3d of posed points, which may belong to any bodies. orient2d projects the points along an
// axis, 0 to 2: it takes their coordinates (axis + 1) mod 3 and (axis + 2) mod 3.
ECODS_API Sign orient2d(const PosedPoint& a, const PosedPoint& b, const PosedPoint& c, int axis) noexcept;
ECODS_API Sign orient3d(const PosedPoint& a, const PosedPoint& b, const PosedPoint& c, const PosedPoint& d) noexcept;

// Return apart, touching or crossing. The result does not depend on the order of the triangles or of their corners.
// Zero-area triangles are the segments or points that they span. Two triangles with an area that share only one point
// are touching; a segment may cross a triangle in one point. Source: Guigue and Devillers, Fast and Robust
// Triangle-Triangle Overlap Test Using Orientation Predicates, 2003, derived again
// (src/exact/simplex/triangle_pair.hpp).
ECODS_API Relation triangle_triangle(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) noexcept;
ECODS_API Relation triangle_triangle(const PosedTriangle& a, const PosedTriangle& b) noexcept;

}  // namespace ecods
