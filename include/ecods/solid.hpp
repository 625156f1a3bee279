// Questions about solids, interiors included: where a point is, what is inside what, how far apart or how deep in each
// other two solids are. No World is needed.
//
//     Solid hall{hall_mesh}, table{table_mesh};
//     solid_relation({table, pose}, {hall, Pose{}}) == Relation::inside
//
// shape.hpp says which meshes bound a solid. A posed solid is the image of the set, R v + t. If R is singular, the
// image is flat and has no interior.
//
// Only the questions of this header count interiors. For all questions of other headers (intersects, distance, hits,
// collisions and so on), a body is its surface, all triangles of its mesh, whether or not its shape is a solid. The
// questions here ignore zero-area parts that stick out of a solid, so bodies may intersect although their solids are
// apart.
//
// Answers are exact for the real points, and depend on the bits of meshes and poses alone; numbers are as in
// distance.hpp. Poses must be finite; a question does not check it. Threads are as in intersection.hpp. For coordinates
// so far apart in scale that their integers need thousands of bits, a question uses up to 256 KiB of stack.
//
// Example: verify/examples/how_do_i, inside_a_solid().
#pragma once

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// ---- solids of any form
//
// Method: signs of determinants of input points alone. If two triangles that are not coplanar share a segment, the
// half-planes of both solids around its line, sorted by angle, say which regions exist there. A shell without such a
// segment is on one side of the other solid's surface; one ray decides on which, from a point that is moved
// symbolically. src/query/solid/README.md proves that nothing else can happen.

// Returns whether the point is inside, outside or on the surface; under a singular pose, outside or on. Throws
// InvalidArgument unless the point is finite. Cost: a walk of the tree along a ray. (CGAL: side_of_triangle_mesh;
// trimesh: contains.)
[[nodiscard]] ECODS_API Location locate(const Vec3& point, const Posed<Solid>& solid, const Ask& ask = {});

// Returns apart, touching, overlapping, inside, contains or equal. A subset may touch the boundary from inside. A solid
// at a singular pose is apart from another solid or touches it, even if it is inside. The empty solid is apart from
// everything. Exchanging a and b exchanges inside and contains.
//
// Cost: if the surfaces are apart, that of intersects() and one ray for each shell; if they meet, about that of
// intersecting_triangles(). Two faces that cross end the search.
[[nodiscard]] ECODS_API Relation solid_relation(const Posed<Solid>& a, const Posed<Solid>& b, const Ask& ask = {});

// Returns the relation of a surface to a solid: apart; touching, if it has no point inside the solid; inside, if it is
// a subset of the solid and has points inside; crossing, if it has points inside and outside. All triangles of the
// surface count; zero-area ones are the segments or points that they span. At a singular pose a solid has no inside.
//
// Cost: that of intersecting_triangles(), a ray for each place where a triangle leaves the solid's surface along an
// edge, and one for each connected part that does not meet it, which a pass over the triangles finds. The search ends
// once points on both sides are found.
[[nodiscard]] ECODS_API Relation surface_relation(const Posed<MeshShape>& surface, const Posed<Solid>& solid,
                                                  const Ask& ask = {});

// Returns proven bounds of the depth of two solids, convex or not; nullopt if they share no point. Throws SingularPose.
// Cost: some tens of solid_relation(), of casts and of distances; for convex solids that of depth() and one or two of
// solid_relation().
[[nodiscard]] ECODS_API std::optional<DepthBounds> depth_bounds(const Posed<Solid>& a, const Posed<Solid>& b,
                                                                const Ask& ask = {});

// ---- convex solids (FCL, Coal: Convex; Bullet, Jolt: ConvexHullShape)
//
// The features of a convex solid are those of the set, however its faces are cut into triangles and its edges into
// pieces. A face is all of its solid in one plane, named by its least triangle, with corner 0. An edge is where two
// faces meet, named by the least side of a triangle that lies on it. A vertex is an end of edges, named by its least
// triangle and corner. All names have indices of the mesh; triangles of zero area name nothing. Under a pose whose
// matrix is regular, the image of a convex solid is convex, and the images of its features are its features.
//
// Method: for distances, the search of Gilbert, Johnson and Keerthi (A fast procedure for computing the distance
// between complex objects, 1988) in doubles guesses the closest features. The signs of a few determinants prove the
// guess, since a point of a convex set that is closest among its neighbors is closest of all; if they do not, exact
// steps continue from there. For depths, a polytope inside the set of differences { p - q : p in a, q in b } grows
// toward the faces that are nearest to the origin (van den Bergen, Proximity Queries and Penetration Depth Computation
// on 3D Game Objects, 2001), in doubles. Exact signs prove that these are faces of the set, and no other is nearer.

// Returns the distance of the sets, which is 0 exactly if they share a point. Starts from a witness, and leaves one.
// Throws SingularPose. Cost: about a microsecond for solids of some tens of faces, less with a witness; some
// microseconds for equal poses and other ties that no double decides. Above a hundred vertices it grows at worst like
// the root of their number.
[[nodiscard]] ECODS_API double solid_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                              const Ask& ask = {});

// Returns the closest points of the sets, and the features that contain them; nullopt if the sets share a point
// (depth() says how deep). If several pairs of features have exactly the least distance, the first one in the order of
// ClosestPoints is given. Exchanging the bodies exchanges a and b, unless several pairs tie. Throws SingularPose.
[[nodiscard]] ECODS_API std::optional<ClosestPoints> solid_closest(const Posed<ConvexSolid>& a,
                                                                   const Posed<ConvexSolid>& b, const Ask& ask = {});

// Returns the depth: the length of the shortest translation of b after which the interiors share no point, and its
// direction; nullopt if the solids share no point (solid_distance() says how far they are). Starts from a witness, and
// leaves one. Throws SingularPose. Cost: some microseconds for solids of some tens of faces; some tens of microseconds
// for ten thousand vertices.
[[nodiscard]] ECODS_API std::optional<Depth> depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                                   const Ask& ask = {});

}  // namespace ecods
