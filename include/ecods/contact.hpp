// Where two bodies meet, and which of their features nearly do. No World is needed.
//
// Numbers are those of the real points, as in distance.hpp; thread safety as in intersection.hpp.
#pragma once

#include <vector>

#include "ecods/distance.hpp"
#include "ecods/export.hpp"
#include "ecods/intersection.hpp"
#include "ecods/shared_set.hpp"

namespace ecods {

// Every pair of triangles that share a point, ascending, with what they share.
// Cost: that of intersecting_triangles, and some microseconds a pair.
ECODS_API std::vector<TriangleIntersection> intersections(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                          QueryMemory& memory);

// close_triangles() reduced to pairs of features, each once: by kind in the order of ClosestKind, then by triangle and
// corner of `a`, then of `b`, then the one whose feature of `a` is the vertex.
//
// Each pair of triangles at a distance of at most d counts with all features that hold two of its closest points, both
// inside: one pair of features as a rule, but of parallel faces every vertex that is over the other face or an edge of
// it, and every two edges that cross, one over the other. These are the corners of the region in which the faces are
// nearest. Triangles that touch count in the same way, at distance 0, with features that have one common point. For
// triangles that cross (Relation::crossing), the kind is `intersecting`, the features are the two faces, and both
// points are the least corner of what they share, as in close_triangles(); intersections() says more. Two features
// within d that hold closest points of no pair of triangles do not count. Which features count depends on no order of
// triangles, corners or bodies.
//
// Throws InvalidArgument if d is negative, NaN or infinity. Cost: that of finding the pairs of triangles, and some
// microseconds for each pair of features and for each pair of triangles with several.
ECODS_API std::vector<CloseFeatures> close_features(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d,
                                                    QueryMemory& memory);

}  // namespace ecods
