// Distance questions say how far two bodies are from each other, and where they are closest. No World is needed.
//
//     ClosestPoints nearest = closest({cube, pose_a}, {cube, pose_b});
//     nearest.distance, nearest.point_a, nearest.point_b
//
// Numbers are those of the real points R v + t, rounded once to the nearest double (ties to even), in any rounding mode
// and whether or not subnormals are flushed; above the largest double they are infinity. A positive distance rounds to
// at least 2^-1074, so a distance is 0 exactly if the bodies share a point. Equal input gives equal bits: no number
// depends on the order of arguments or triangles, the witness, memory, instruction set or compiler.
//
// Bodies, finite poses and threads are as in intersection.hpp: a body inside a solid is at distance 0 from it. For
// coordinates so far apart in scale that their integers need thousands of bits, a question uses up to 256 KiB of stack.
//
// Method: best-first walk of both trees of boxes (Hjaltason and Samet, Distance Browsing in Spatial Databases, 1999;
// for two trees Larsen, Gottschalk, Lin and Manocha, Fast Distance Queries with Rectangular Swept Sphere Volumes, 2000)
// with lower bounds rounded outwards, enclosures of the distances of triangles with proven bounds, and integers if the
// enclosures do not decide. Two convex solids are searched as solid.hpp describes, in about a microsecond for solids of
// some tens of faces, less with a witness, and some microseconds for ties that no double decides.
//
// Example: verify/examples/how_do_i, distance_with_points().
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns the distance: the least |p - q| of points p of a and q of b. Starts from a witness, and leaves the closest
// triangles in it. Cost: that of the walk. Each pair of triangles that is a candidate costs about 0.1 microseconds; the
// last few, which are rounded, about one microsecond more.
[[nodiscard]] ECODS_API double distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// Returns true if the real distance is at most max_distance, compared exactly: a rounded distance and its neighbors
// give different answers. Infinity is allowed. Throws InvalidArgument if max_distance is negative or NaN. within(a, b,
// 0) is intersects(a, b). (FCL, Coal: security margin.)
[[nodiscard]] ECODS_API bool within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance,
                                    const Ask& ask = {});

// Returns the closest points, and the features that contain them. Exchanging the bodies exchanges a and b, unless
// several pairs of features tie. (FCL: nearest_points; Parry: closest_points.)
[[nodiscard]] ECODS_API ClosestPoints closest(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                              const Ask& ask = {});

// Return the distance of a point from a body, and the body's closest point; or both for each of many points, in their
// order. ClosestPoint says which closest point is given if several tie. Answers are those of closest() and distance()
// for a body that is the point alone. No witness is read or left. Throw InvalidArgument unless points are finite;
// `index` says which of many is not. (CGAL: AABB_tree, closest_point_and_primitive; trimesh: proximity.closest_point.)
//
// Method: a walk of the body's tree, nearest boxes first, eight at once. Cost: about a microsecond for a point near a
// mesh of ten thousand triangles, and half of it again for each point that is rounded. For many points, the body is
// prepared once.
[[nodiscard]] ECODS_API ClosestPoint closest(const Eigen::Ref<const Vec3>& point, const Posed<MeshShape>& body,
                                             const Ask& ask = {});
[[nodiscard]] ECODS_API std::vector<ClosestPoint> closest(std::span<const Vec3> points, const Posed<MeshShape>& body,
                                                          const Ask& ask = {});

// Return the distance of a point from the body's surface, or of each of many points, in their order: negative if the
// point is inside a solid, positive if it is outside, and 0 exactly if it is on the surface. A surface, and a solid at
// a singular pose, has no inside. Throw InvalidArgument as closest() does. Cost: less than that of closest(), as no
// point is rounded. The closest face or edge shows whether the point is inside; a locate() is needed only if a vertex
// is closest or if several features tie. (trimesh: proximity.signed_distance, with the other sign.)
[[nodiscard]] ECODS_API double signed_distance(const Eigen::Ref<const Vec3>& point, const Posed<MeshShape>& body,
                                               const Ask& ask = {});
[[nodiscard]] ECODS_API std::vector<double> signed_distance(std::span<const Vec3> points, const Posed<MeshShape>& body,
                                                            const Ask& ask = {});

// A DistanceTolerance says how narrow an interval must be. None of its numbers may be negative or NaN
// (InvalidArgument).
struct DistanceTolerance {
    double relative = 0;
    double absolute = 0;
    // If the distance is above max_distance, a lower bound above max_distance suffices.
    double max_distance = std::numeric_limits<double>::infinity();
};

// Returns an interval that contains the distance: upper - lower <= max(absolute, relative * lower), or both are equal
// or adjacent doubles. If lower > max_distance, upper may be infinity. Unlike all other answers, this one depends on
// the witness, the memory and the order of the bodies: only that it contains the distance and is narrow enough is
// promised.
[[nodiscard]] ECODS_API DistanceBounds distance_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                       const DistanceTolerance& tolerance, const Ask& ask = {});

// Returns an interval that contains the signed distance. The signed distance is the distance of bodies that share no
// point; minus the depth of two solids that do (solid.hpp); and 0 if the bodies share a point and at least one of them
// is a surface, or is flat and the other one not convex. Both ends are the exact number, rounded once, with one
// exception: for solids that share inner points and are not both convex, the ends are minus those of depth_bounds(). A
// solid under a singular pose counts as a surface, because its image is flat. So `lower` is negative exactly if two
// solids share inner points, or a flat convex solid and another convex one cross or contain each other; and `upper` is
// positive exactly if the bodies are apart. Cost: that of distance(), and of depth() or depth_bounds().
// (signed_distance() of two convex solids has points, too.)
[[nodiscard]] ECODS_API DistanceBounds signed_distance_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                              const Ask& ask = {});

// Returns every pair of triangles at a distance of at most max_distance, ascending, each with its own closest points.
// For a solid, only triangles of positive area count. Throws InvalidArgument if max_distance is negative, NaN or
// infinite.
[[nodiscard]] ECODS_API std::vector<ClosestPoints> close_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                                   double max_distance, const Ask& ask = {});

// Returns close_triangles() reduced to pairs of features, each pair once. The pairs are in the order of ClosestKind,
// then of triangle and corner of `a`, then of `b`; of two that are still equal, the pair whose feature of `a` is the
// vertex comes first. (FCL, Bullet: contact manifold, without a choice of points.)
//
// Each pair of triangles at a distance of at most max_distance contributes all pairs of features that contain two of
// its closest points in their interiors. Usually this is one pair of features. Parallel faces contribute every vertex
// that is over the other face or an edge of it, and every two edges that cross, one over the other: the corners of the
// region in which the faces are nearest. Triangles that touch contribute in the same way, at distance 0, the features
// that have one common point. For triangles that cross (Relation::crossing), the kind is `intersecting`, the features
// are the two faces, and both points are the least corner of the shared set, as in close_triangles(); intersections()
// says more. Two features within the limit that contain closest points of no pair of triangles are not returned. The
// result does not depend on the order of triangles, corners or bodies.
//
// Throws InvalidArgument if max_distance is negative, NaN or infinite. Cost: that of finding the pairs of triangles,
// and some microseconds for each pair of features and for each pair of triangles with several.
[[nodiscard]] ECODS_API std::vector<CloseFeatures> close_features(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                                  double max_distance, const Ask& ask = {});

}  // namespace ecods
