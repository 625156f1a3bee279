// Two posed convex solids by reference, as integers take them.
#pragma once

#include <array>
#include <cstdint>

#include "exact/point/frame.hpp"
#include "query/convex/hull.hpp"

namespace ecods::depths {

// A convex solid at a pose, by reference. `body` has the mesh whose vertices the hull names, and what contains it.
struct ConvexBody {
    const convex::Hull* hull;
    exact::BodyRef body;

    const Vec3& vertex(std::uint32_t v) const noexcept { return body.mesh->vertices()[hull->mesh_vertices[v]]; }
};

using ConvexPair = std::array<ConvexBody, 2>;

}  // namespace ecods::depths
