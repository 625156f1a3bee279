// Distance questions say how far two bodies are from each other, and where they are closest. No World is needed.
//
//     ClosestPoints nearest = closest({cube, pose_a}, {cube, pose_b});
//     nearest.distance, nearest.point_a, nearest.point_b
//
// Numbers are those of the real points R v + t, rounded once to the nearest double (ties to even), in any rounding mode
// and whether or not subnormals are flushed; above the largest double they are infinity. A positive distance rounds to
// at least 2^-1074, so a distance is 0 exactly if the bodies share a point. So equal input gives equal bits: no number
// depends on the order of arguments or triangles, the witness, memory, instruction set or compiler.
//
// Bodies, finite poses and threads are as in intersection.hpp: what is inside a solid is at distance 0 from it. For
// coordinates so far apart in scale that their integers need thousands of bits, a question uses up to 256 KiB of stack.
//
// Method: best-first walk of both trees of boxes (Hjaltason and Samet, Distance Browsing in Spatial Databases, 1999;
// for two trees Larsen, Gottschalk, Lin and Manocha, Fast Distance Queries with Rectangular Swept Sphere Volumes, 2000)
// with lower bounds rounded outwards, enclosures of the distances of triangles with proven bounds, and integers if
// these do not decide. For two convex solids: the search that solid.hpp names. It takes about a microsecond for solids
// of some tens of faces, less with a witness, and some microseconds for ties that no double decides.
//
// Example: verify/examples/how_do_i, distance_with_points().
#pragma once

#include <limits>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns the distance: the least |p - q| of points p of a and q of b. Starts from a witness, and leaves the closest
// triangles in it. Cost: that of the walk. A pair of triangles that is a candidate costs about 0.1 microseconds; the
// last one or few, which are rounded, about one microsecond more.
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

// Says how narrow an interval must be. None of the numbers may be negative or NaN (InvalidArgument).
struct DistanceTolerance {
    double relative = 0;
    double absolute = 0;
    // Distances above this need not be distinguished.
    double max_distance = std::numeric_limits<double>::infinity();
};

// Returns an interval that contains the distance: upper - lower <= max(absolute, relative * lower), or both are equal
// or adjacent doubles. If lower > max_distance, upper may be infinity. This answer, unlike all others, depends on the
// witness, the memory and the order of the bodies: only that it contains the distance and is narrow enough is promised.
[[nodiscard]] ECODS_API DistanceBounds distance_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                       const DistanceTolerance& tolerance, const Ask& ask = {});

// Returns every pair of triangles, of solids those of positive area, at a distance of at most max_distance, ascending,
// each with its own closest points. Throws InvalidArgument if max_distance is negative, NaN or infinite.
[[nodiscard]] ECODS_API std::vector<ClosestPoints> close_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                                   double max_distance, const Ask& ask = {});

// Returns close_triangles() reduced to pairs of features, each once: in the order of ClosestKind, then of triangle and
// corner of `a`, then of `b`; then the pair whose feature of `a` is the vertex. (FCL, Bullet: contact manifold, without
// a choice of points.)
//
// Each pair of triangles at a distance of at most max_distance counts with all pairs of features that contain two of
// its closest points in their interiors. Usually this is one pair of features. For parallel faces it is every vertex
// that is over the other face or an edge of it, and every two edges that cross, one over the other: the corners of the
// region in which the faces are nearest. Triangles that touch count in the same way, at distance 0, with features that
// have one common point. For triangles that cross (Relation::crossing), the kind is `intersecting`, the features are
// the two faces, and both points are the least corner of what they share, as in close_triangles(); intersections() says
// more. Two features within the limit that contain closest points of no pair of triangles do not count. The result does
// not depend on the order of triangles, corners or bodies.
//
// Throws InvalidArgument if max_distance is negative, NaN or infinite. Cost: that of finding the pairs of triangles,
// and some microseconds for each pair of features and for each pair of triangles with several.
[[nodiscard]] ECODS_API std::vector<CloseFeatures> close_features(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                                  double max_distance, const Ask& ask = {});

}  // namespace ecods
