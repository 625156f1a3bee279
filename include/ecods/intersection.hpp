// Intersection questions say whether two bodies meet, how, and where (FCL, Coal: collide; Parry: intersection_test;
// Bullet: contactPairTest; PQP: PQP_Collide). No World is needed.
//
//     auto cube = std::make_shared<MeshShape>(mesh);
//     bool touch = intersects({cube, pose_a}, {cube, pose_b});
//
// A body is the set of the real points R v + t for the points v of its shape (shape.hpp). A MeshShape is a surface: the
// closed triangles. A Solid or ConvexSolid also contains the points inside. Each answer is exact, and depends on the
// bits of meshes and poses alone: swapping the bodies gives the same answer (and swapped triangle pairs). Everything is
// defined for all finite poses, also singular ones, under which a solid is a flat surface; and for zero-area triangles:
// in a surface they are the segments or points that they span, and in a solid they do not count. A pose must be finite
// (validate(Pose)); a question does not check it.
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

// Returns true if the bodies share a point; stops at the first one found. Touching counts, and so does being inside a
// solid. Starts from a witness and leaves one.
// Cost for solids whose surfaces share no point: that of the surfaces; and, unless an axis separates the whole bodies,
// a box of each, and a ray for each connected part that has a vertex in the other's box.
[[nodiscard]] ECODS_API bool intersects(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// Returns the relation of the first body to the second.
//
// Two surfaces are apart, touching or crossing: the strongest relation of any triangle of a and any triangle of b. The
// search stops at the first crossing. A surface and a solid are apart; or touching, if the surface has no point inside
// the solid; or the surface is inside (and the solid contains it), if it is a subset of the solid and has points
// inside; or they are crossing, if the surface has points inside and outside. Two solids are apart, touching,
// overlapping, equal, or one is inside the other, which contains it; a subset may touch the boundary from inside. A
// solid at a singular pose has no inside. If it is a subset of another solid, the two are touching.
//
// Method for solids: signs of determinants of input points alone. If two triangles that are not coplanar share a
// segment, the half-planes of both solids around its line, sorted by angle, say which regions exist there. A shell
// without such a segment is on one side of the other solid's surface; one ray decides on which, from a point that is
// moved symbolically. src/query/solid/README.md proves that no other case exists.
// Cost for solids: if the surfaces are apart, that of intersects(); if they meet, about that of
// intersecting_triangles(). Two faces that cross end the search.
[[nodiscard]] ECODS_API Relation relation(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// Returns every pair of triangles that share a point, ascending. For a solid, only triangles of positive area count;
// two solids may meet without such a pair.
[[nodiscard]] ECODS_API std::vector<TrianglePair> intersecting_triangles(const Posed<MeshShape>& a,
                                                                         const Posed<MeshShape>& b,
                                                                         const Ask& ask = {});

// Returns the pairs of intersecting_triangles(), each with the points that the two triangles share. Cost: that of
// intersecting_triangles(), and some microseconds a pair.
[[nodiscard]] ECODS_API std::vector<TriangleIntersection> intersections(const Posed<MeshShape>& a,
                                                                        const Posed<MeshShape>& b, const Ask& ask = {});

}  // namespace ecods
