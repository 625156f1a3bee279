// What a segment or a ray meets of a body, and in which order. No World is needed.
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
// or points that they span, and for a segment of length 0, which is a point. A pose must be finite (validate(Pose)); a
// query does not check it.
//
// Thread safety: as in intersection.hpp.
#pragma once

#include <optional>
#include <vector>

#include "ecods/export.hpp"
#include "ecods/intersection.hpp"
#include "ecods/segment.hpp"
#include "ecods/triangle_hit.hpp"

namespace ecods {

// The hit of least parameter, and of those, of the least triangle; nothing if there is none. Throw InvalidArgument.
// Cost: a walk along the line, nearest boxes first; then some tenths of a microsecond for each triangle that doubles
// do not part from the first, and for rounding.
ECODS_API std::optional<Hit> first_hit(const Segment& segment, const Posed<MeshShape>& body, QueryMemory& memory);
ECODS_API std::optional<Hit> first_hit(const Ray& ray, const Posed<MeshShape>& body, QueryMemory& memory);

// The same, for a segment or ray that has moved little since it was asked about: tries the witness's triangle `b`
// first, and leaves the one hit. The witness may come from any question and any bodies. Of a segment that goes on in
// small steps, one memory keeps what is near its way: most steps then need no walk.
ECODS_API std::optional<Hit> first_hit(const Segment& segment, const Posed<MeshShape>& body, QueryMemory& memory,
                                       PairWitness& witness);
ECODS_API std::optional<Hit> first_hit(const Ray& ray, const Posed<MeshShape>& body, QueryMemory& memory,
                                       PairWitness& witness);

// Every triangle that is hit, once, ascending by real parameter, then by triangle.
ECODS_API std::vector<Hit> all_hits(const Segment& segment, const Posed<MeshShape>& body, QueryMemory& memory);
ECODS_API std::vector<Hit> all_hits(const Ray& ray, const Posed<MeshShape>& body, QueryMemory& memory);

}  // namespace ecods
