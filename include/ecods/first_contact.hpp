// When two bodies first meet, and with which of their features (cast.hpp says how to ask).
#pragma once

#include "ecods/closest_points.hpp"
#include "ecods/ids.hpp"

namespace ecods {

// The first contact of two bodies, and the first pair of features, in the order of ClosestPoints, of those that share a
// point at a time that rounds to it.
//
// For each pair of triangles, the features that count are those that share a point at the first real time at which that
// pair does: the lowest in dimension that hold it, of the triangles as they are then. Those pairs of triangles count
// whose first time rounds to `time`. At time 0 the kind is `intersecting`: the features are both faces, of the least
// pair of triangles that share a point at the start.
struct FirstContact {
    double time = 0;
    ClosestKind kind = ClosestKind::intersecting;
    Feature a, b;

    TrianglePair triangles() const noexcept { return {a.triangle, b.triangle}; }
    friend bool operator==(const FirstContact&, const FirstContact&) = default;
};

}  // namespace ecods
