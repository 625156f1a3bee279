// Hits are the points where a segment or a ray meets a body, in their order (Parry, Jolt, Box3D: cast_ray). No World is
// needed.
//
//     std::optional<Hit> hit = first_hit(Ray{eye, direction}, {cube, pose});
//     if (hit) hit->parameter, hit->point, hit->triangle()
//
// A body is as in intersection.hpp. A line that begins inside a solid, and not on its surface, hits the solid at
// parameter 0, with the kind `inside`, and then its surface. A triangle is hit if it shares a point with the segment or
// ray, ends included. So nothing leaks through an edge or a vertex, where every triangle with this edge or vertex is
// hit; and a triangle that is only close is not hit. Real numbers decide, in any rounding mode.
//
// The parameter of a point of a segment is 0 at its first end and 1 at its second; for a ray it is the multiple of the
// direction. Parameters and coordinates are the true ones, rounded once (distance.hpp says how). A positive parameter
// is at least 2^-1074, so it is 0 exactly if the beginning is on the surface; beyond the largest double it is infinity.
// Hits are in the order of the real parameters, not of the rounded ones.
//
// Everything is defined for all finite poses, also singular ones; for zero-area triangles, which are the segments or
// points that they span; and for a segment of length 0, which is a point. Threads are as in intersection.hpp. All
// functions throw InvalidArgument if validate() refuses the segment or ray.
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

// Returns the hit with the least parameter, of several with the least triangle; nullopt if there is no hit.
//
// Use a witness for a line that moves little: its triangle `b` is tried first, and replaced by the triangle that is
// hit. If a segment moves in small steps, its memory keeps the triangles near its path, and most steps need no walk.
// Cost: a walk along the line, nearest boxes first; then some tenths of a microsecond for each triangle whose hit
// doubles cannot separate from the first, and for rounding.
[[nodiscard]] ECODS_API std::optional<Hit> first_hit(const Segment& segment, const Posed<MeshShape>& body,
                                                     const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<Hit> first_hit(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask = {});

// Return the hit of every triangle that is hit, ascending by real parameter, then by triangle.
[[nodiscard]] ECODS_API std::vector<Hit> all_hits(const Segment& segment, const Posed<MeshShape>& body,
                                                  const Ask& ask = {});
[[nodiscard]] ECODS_API std::vector<Hit> all_hits(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask = {});

}  // namespace ecods
