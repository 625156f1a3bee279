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
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <iosfwd>

#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"

namespace ecods {

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
