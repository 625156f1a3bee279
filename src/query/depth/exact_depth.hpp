// Computes the depth of two convex solids in integers alone. The computation is exact for every finite input, but slow.
#pragma once

#include <optional>
#include <vector>

#include "query/depth/convex_pair.hpp"
#include "query/depth/difference_face.hpp"

namespace ecods::depths {

// An ExactDepth holds the face of the Minkowski difference that is nearest to the origin (the first one of ties), its
// distance, and its outer unit normal. The numbers are rounded once.
struct ExactDepth {
    DifferenceFace face;
    double depth = 0;
    Vec3 direction = Vec3::Zero();
};

// Returns the depth; nullopt if the solids share no point. The Minkowski difference must not lie in a plane.
//
// The algorithm grows the hull of some points of the Minkowski difference. It picks a face nearest to the origin; the
// distance counts as negative if the origin is beyond the face. While that face is not in a face of the whole
// difference, the vertex furthest beyond the face is added. Every step adds a vertex of the difference, so the
// algorithm ends. At the end, no face of the hull is nearer than the picked one, which is in a face of the difference.
// The hull is inside the difference, so no face of the difference is nearer.
//
// All faces of the difference that tie with the picked face are faces of the hull, too. If the distance d is positive,
// the ball of radius d is inside the hull, and touches the difference's border only where it touches the hull's. If d
// is 0, the normals of all planes through the origin that have the difference on one side form a cone, whose extreme
// rays are the normals of faces. The cone of the hull contains the difference's cone, and is no larger, since all
// nearest faces of the hull are faces of the difference.
std::optional<ExactDepth> exact_depth(const ConvexPair& pair);

// Returns the depth of two flat solids that share a point, which is 0, if their Minkowski difference lies in a plane;
// otherwise nullopt. The face consists of both whole solids. Cost: constant; if one is a polygon, also a sign for each
// vertex of the other.
std::optional<ExactDepth> depth_in_plane(const ConvexPair& pair);

// Returns the depth of two solids whose nearest face of the Minkowski difference is `face`. `corners` must be three
// vertices of the Minkowski difference in the plane of this face, not on one line, counterclockwise seen from outside.
ExactDepth measure_exactly(const ConvexPair& pair, const DifferenceFace& face,
                           const std::array<DifferenceVertex, 3>& corners);

// Returns the vertex furthest along the normal of the plane through `corners` if it is beyond the plane. Otherwise
// returns nullopt, and reduces the lists `levels` to the vertices in the plane. The lists must be ascending, and
// contain all vertices that are extreme along the normal, or for the second solid in the opposite direction.
std::optional<DifferenceVertex> keep_level(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                                           std::array<std::vector<std::uint32_t>, 2>& levels);

// Returns true if `vertex` is strictly beyond the plane through the three `corners`.
bool is_beyond_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                       const DifferenceVertex& vertex);

// Returns the sign of (distance of the first plane from the origin) - (distance of the second plane). Each plane is
// given by three vertices.
int compare_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& first,
                    const std::array<DifferenceVertex, 3>& second);

}  // namespace ecods::depths
