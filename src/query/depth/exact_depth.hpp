// Finds the depth of two convex solids in integers alone: complete for every finite input, and expensive.
#pragma once

#include <optional>
#include <vector>

#include "query/depth/convex_pair.hpp"
#include "query/depth/difference_face.hpp"

namespace ecods::depths {

// A face of the Minkowski difference that is nearest to the origin, the first one of ties; its distance, and its outer
// unit normal, each rounded once.
struct ExactDepth {
    DifferenceFace face;
    double depth = 0;
    Vec3 direction = Vec3::Zero();
};

// The depth; nullopt if the solids share no point.
//
// A hull of some points of the Minkowski difference grows. It picks a face nearest to the origin; the distance counts
// as negative if the origin is beyond the face. While that face is not in a face of the whole difference, it adds the
// vertex furthest beyond the face. Every step adds a vertex of the difference, so it ends. Then no face of the hull is
// nearer than the picked one, which is in a face of the difference. So no face of the difference is nearer, because the
// hull is inside it.
//
// All faces of the difference that tie with it are faces of the hull, too. If the distance d is positive, the ball of
// radius d is inside the hull, and touches the difference's border only where it touches the hull's. If d is 0, the
// normals of all planes through the origin that have the difference on one side form a cone, whose extreme rays are the
// normals of faces. The cone of the hull contains the difference's cone, and is no larger, since all nearest faces of
// the hull are faces of the difference.
std::optional<ExactDepth> exact_depth(const ConvexPair& pair);

// The depth from a known face. `corners` are three vertices of the Minkowski difference in its plane, counterclockwise
// from outside, not on one line.
ExactDepth measure_exactly(const ConvexPair& pair, const DifferenceFace& face,
                           const std::array<DifferenceVertex, 3>& corners);

// Returns the furthest vertex along the normal of the plane through `corners` if it is beyond the plane. Otherwise
// reduces the lists `levels` to the vertices in the plane. The lists must be ascending, and contain all vertices that
// are extreme along the normal, or against it for the second solid.
std::optional<DifferenceVertex> keep_level(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                                           std::array<std::vector<std::uint32_t>, 2>& levels);

// True if a vertex is strictly beyond the plane through three.
bool is_beyond_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                       const DifferenceVertex& vertex);

// Compares the distances of two planes from the origin, each through three vertices: the sign of first minus second.
int compare_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& first,
                    const std::array<DifferenceVertex, 3>& second);

}  // namespace ecods::depths
