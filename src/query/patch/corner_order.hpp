// Orders the corners of a patch around its normal, without looking at coordinates.
//
// Seen along the normal, a patch is the intersection of two convex polygons. Let the patch have three corners or more.
// Then it has an area, both polygons are faces, and each side of the patch is on an edge of one of the polygons. All of
// the patch is on one side of the line of this edge. So the closed edge contains the two ends of the side, and no third
// corner. Conversely, if two corners are on one closed edge, the patch has no points beyond its line, and they are the
// ends of a side. Hence two corners are neighbors if and only if some closed edge of a polygon contains both.
//
// The direction follows from any side whose ends are at different places of their edge: at its beginning, inside, or at
// its end. If there is no such side, all corners are crossings of two edges u and v, each directed counterclockwise.
// The patch is on the left of both; so if v turns left from u, the way around the patch arrives along u and leaves
// along v.
#pragma once

#include <array>
#include <cstddef>

#include "query/convex/closest_hulls.hpp"
#include "query/patch/polygon.hpp"

namespace ecods::patches {

using convex::HullFeaturePair;
using Polygons = std::array<Polygon, 2>;

// Turn::of() returns the sign of the turn from the first polygon's edge to the second's, for two edges that cross. Each
// edge has its direction in its polygon.
class Turn {
  public:
    virtual int of(const HullFeaturePair& edges) const = 0;

  protected:
    ~Turn() = default;
};

// Sorts the corners counterclockwise around the normal, beginning with the corner at index `first`. `corners` must
// contain all corners of the intersection of the polygons.
void order_around(const Polygons& polygons, std::size_t first, convex::LeastPairs& corners, const Turn& turn);

}  // namespace ecods::patches
