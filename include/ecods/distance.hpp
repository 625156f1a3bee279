// How far two bodies are from each other. No World is needed.
//
// Numbers are those of the real points R v + t, rounded once to the nearest double (ties to even), whatever rounding
// mode is set and whether or not subnormals are flushed; above the largest double they are infinity. A distance that is
// positive rounds to at least 2^-1074: a distance is 0 exactly when the bodies share a point. So equal input gives
// equal bits: no order of arguments or triangles, witness, memory, instruction set or compiler shows in a number.
//
// Everything is defined for all finite poses, singular ones included, and for zero-area triangles, which are the
// segments or points that they span. A pose must be finite (validate(Pose)); a query does not check it.
//
// Method: best-first walk of both trees of boxes (Hjaltason and Samet, Distance Browsing in Spatial Databases, 1999;
// for two trees Larsen, Gottschalk, Lin and Manocha, Fast Distance Queries with Rectangular Swept Sphere Volumes, 2000)
// with lower bounds rounded outwards, enclosures of the distances of triangles with proven bounds, and integers for
// what these leave open.
//
// Thread safety: as in intersection.hpp. For coordinates so far apart in scale that their integers need thousands of
// bits, a query uses up to 256 KiB of stack.
#pragma once

#include <limits>
#include <vector>

#include "ecods/closest_points.hpp"
#include "ecods/export.hpp"
#include "ecods/intersection.hpp"

namespace ecods {

// The distance: the least |p - q| of points p of a and q of b.
// Cost: that of the walk; a pair of triangles that is a candidate costs about 0.1 microseconds, the last one or few,
// which are rounded, about one more.
ECODS_API double distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);

// The same, for a pair that was asked about before and has moved little: tries the witness's triangles first, and
// leaves the closest ones. The witness may come from any question and any bodies.
ECODS_API double distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
                          PairWitness& witness);

// Whether the distance is at most d, decided for the real number: d may be the rounded distance, or a neighbour of it.
// Infinity is allowed. Throws InvalidArgument if d is negative or NaN. within(a, b, 0) is intersects(a, b).
ECODS_API bool within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d, QueryMemory& memory);
ECODS_API bool within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d, QueryMemory& memory,
                      PairWitness& witness);

// The closest points, and what they are on. Exchanging the bodies exchanges a and b, unless several pairs of features
// tie.
ECODS_API ClosestPoints closest(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);
ECODS_API ClosestPoints closest(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
                                PairWitness& witness);

// How narrow an interval is wanted. None of the numbers may be negative or NaN (InvalidArgument).
struct DistanceTolerance {
    double relative = 0;
    double absolute = 0;
    // Distances above this need not be distinguished.
    double at_most = std::numeric_limits<double>::infinity();
};

struct DistanceBounds {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
};

// An interval that contains the distance: upper - lower <= max(absolute, relative * lower), or both are equal or
// adjacent doubles. Once lower > at_most, upper may be infinity. Only this depends on the witness, the memory and the
// order of the bodies: it promises that it contains the truth and is as narrow as asked, and no more.
ECODS_API DistanceBounds distance_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                         const DistanceTolerance& tolerance, QueryMemory& memory);
ECODS_API DistanceBounds distance_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                         const DistanceTolerance& tolerance, QueryMemory& memory, PairWitness& witness);

// Every pair of triangles at a distance of at most d, ascending, each with its own closest points. Throws
// InvalidArgument if d is negative, NaN or infinity.
ECODS_API std::vector<ClosestPoints> close_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d,
                                                     QueryMemory& memory);

}  // namespace ecods
