// Defines ConvexPair: two posed convex solids, as the hulls and poses from which exact integer points are made.
#pragma once

#include <array>
#include <cstdint>

#include "exact/point/frame.hpp"
#include "query/convex/hull.hpp"

namespace ecods::depths {

// A ConvexBody refers to a posed convex solid. `body` has the mesh whose vertices the hull refers to, and the extent of
// that mesh.
struct ConvexBody {
    const convex::Hull* hull;
    exact::BodyRef body;

    const Vec3& vertex(std::uint32_t v) const noexcept { return body.mesh->vertices()[hull->mesh_vertices[v]]; }
};

using ConvexPair = std::array<ConvexBody, 2>;

}  // namespace ecods::depths
