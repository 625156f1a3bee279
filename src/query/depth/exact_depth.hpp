// The depth of two convex solids in integers alone: complete for every finite input, and dear.
#pragma once

#include <optional>
#include <vector>

#include "query/depth/convex_pair.hpp"
#include "query/depth/difference_face.hpp"

namespace ecods::depths {

// A face of the set of differences that is nearest to the origin, the first of those that tie; how far it is, and its
// outer unit normal, rounded once.
struct ExactDepth {
    DifferenceFace face;
    double depth = 0;
    Vec3 direction = Vec3::Zero();
};

// Nothing if the solids share no point.
//
// The hull of some points of the set of differences grows: while a face of it that is nearest to the origin, its
// distance counted as negative where the origin is beyond it, is not one of the whole set, the vertex that is furthest
// beyond it is added. Every step adds a vertex of the set, so it ends. Then no face of the hull is nearer than that
// which is one of the set, so none of the set is: the hull is inside it.
//
// Those of the set that are as near are faces of the hull, too. Where the distance d is positive, the ball of radius d
// is inside the hull and touches the set's border only where it touches the hull's. Where it is 0, the normals of all
// planes through the origin that have the set on one side are a cone, whose extreme rays are the normals of faces; that
// of the hull contains it, and is no larger, since all of the hull's faces that are nearest are faces of the set.
std::optional<ExactDepth> exact_depth(const ConvexPair& pair);

// The same of a face that is known: the plane of three vertices of the set of differences, counterclockwise from
// outside, which are not on one line.
ExactDepth measure_exactly(const ConvexPair& pair, const DifferenceFace& face,
                           const std::array<DifferenceVertex, 3>& corners);

// Of vertices of both solids, ascending, among which are all that are furthest along the normal of the plane of three
// vertices of the set of differences, and against it. If what is furthest is beyond the plane, returns it. Otherwise
// keeps those that are in the plane.
std::optional<DifferenceVertex> keep_level(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                                           std::array<std::vector<std::uint32_t>, 2>& levels);

// Whether a vertex is strictly beyond the plane of three.
bool is_beyond_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                       const DifferenceVertex& vertex);

// The sign of how much further from the origin the plane of the first three vertices is than that of the second.
int compare_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& first,
                    const std::array<DifferenceVertex, 3>& second);

}  // namespace ecods::depths
