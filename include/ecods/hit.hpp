// Hits are the points where a segment or a ray meets a body, in their order (Parry, Jolt, Box3D: cast_ray). No World is
// needed.
//
//     std::optional<Hit> hit = first_hit(Ray{eye, direction}, {cube, pose});
//     if (hit) hit->parameter, hit->point, hit->triangle()
//
// A body is its surface: the closed triangles of the real points R v + t. A triangle is hit when it shares a point with
// the segment or ray, ends included: nothing leaks through an edge or a vertex, of which every triangle is hit, and
// nothing is hit that only comes close. Decided for the real numbers, in any rounding mode.
//
// The parameter of a point is 0 at the first end of a segment and 1 at the second, or the multiple of the direction of
// a ray. Parameters and coordinates are the true ones, rounded once (distance.hpp says how); a positive parameter is at
// least 2^-1074, so that it is 0 exactly when the beginning is on the surface; beyond the largest double it is
// infinity. Hits are in the order of the real parameters, not of the rounded ones.
//
// Everything is defined for all finite poses, singular ones included, for zero-area triangles, which are the segments
// or points that they span, and for a segment of length 0, which is a point. Threads are as in intersection.hpp. All
// throw InvalidArgument where validate() refuses the segment or ray.
//
// Example: verify/examples/how_do_i, ray().
#pragma once

#include <optional>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns the hit of least parameter, and of those, of the least triangle; empty if there is none.
//
// A witness is for a line that has moved little: its triangle `b` is tried first, and replaced by the one hit. If a
// segment goes on in small steps, one memory keeps the triangles near its way, and most steps need no walk.
// Cost: a walk along the line, nearest boxes first; then some tenths of a microsecond for each triangle that doubles
// do not part from the first, and for rounding.
[[nodiscard]] ECODS_API std::optional<Hit> first_hit(const Segment& segment, const Posed<MeshShape>& body,
                                                     const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<Hit> first_hit(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask = {});

// Return every triangle that is hit, once, ascending by real parameter, then by triangle.
[[nodiscard]] ECODS_API std::vector<Hit> all_hits(const Segment& segment, const Posed<MeshShape>& body,
                                                  const Ask& ask = {});
[[nodiscard]] ECODS_API std::vector<Hit> all_hits(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask = {});

}  // namespace ecods
