// Computes in integers the depth of two convex solids along a direction.
#pragma once

#include <optional>

#include "query/depth/convex_pair.hpp"
#include "query/depth/difference_face.hpp"

namespace ecods::depths {

struct ExactDepthAlong {
    DifferenceFace face;  // the face through which the line from the origin leaves the difference, the first of several
    double parameter = 0, length = 0;
    Vec3 normal = Vec3::Zero();  // the face's outer unit normal
};

// Returns the greatest s >= 0 for which the point s d is in the Minkowski difference, with the face there; nullopt if
// the solids share no point. If the origin is on the border, s is 0, and the face is the first that contains the
// origin. d must be finite, and not zero.
//
// The line leaves a convex polytope that contains the origin through the plane n . x = h with the least h / n . d,
// among the planes with n . d > 0. So the algorithm is that of exact_depth() with another order of planes. Planes that
// tie at the end contain the point where the line leaves. There, the grown polytope is bounded by planes of faces of
// the whole difference, which contains the polytope: both have the same planes there.
std::optional<ExactDepthAlong> exact_depth_along(const ConvexPair& pair, const Vec3& d);

}  // namespace ecods::depths
