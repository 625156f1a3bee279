// Intersection questions say whether two bodies meet, how, and where (FCL, Coal: collide; Parry: intersection_test). No
// World is needed.
//
//     auto cube = std::make_shared<MeshShape>(mesh);
//     bool touch = intersects({cube, pose_a}, {cube, pose_b});
//
// A body is the surface of its shape: the closed triangles of the real points R v + t. Each answer is exact, and
// depends on the bits of meshes and poses alone: swapping the bodies gives the same answer (and swapped triangle
// pairs). Everything is defined for all finite poses, also singular ones, and for zero-area triangles, which are the
// segments or points that they span. A pose must be finite (validate(Pose)); a question does not check it.
//
// Thread safety: shapes are immutable, so several threads may ask questions at the same time; each question that is
// given a QueryMemory needs one of its own.
//
// Example: verify/examples/how_do_i, touch().
#pragma once

#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns true if the bodies share a point; stops at the first one found. Touching counts. Starts from a witness and
// leaves one.
[[nodiscard]] ECODS_API bool intersects(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// Returns apart, touching or crossing: the strongest relation of any triangle of a and any triangle of b. Stops at the
// first crossing.
[[nodiscard]] ECODS_API Relation relation(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// Returns every pair of triangles that share a point, ascending.
[[nodiscard]] ECODS_API std::vector<TrianglePair> intersecting_triangles(const Posed<MeshShape>& a,
                                                                         const Posed<MeshShape>& b,
                                                                         const Ask& ask = {});

// Returns the same pairs with the points that the triangles share. Cost: that of intersecting_triangles(), and some
// microseconds a pair.
[[nodiscard]] ECODS_API std::vector<TriangleIntersection> intersections(const Posed<MeshShape>& a,
                                                                        const Posed<MeshShape>& b, const Ask& ask = {});

}  // namespace ecods
