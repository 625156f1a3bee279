// Two posed convex solids as what their depth is found from: vertices, edges, faces, and the points of vertices.
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

// A vertex p of the first solid less a vertex q of the second, by their indices in the hulls. The set of differences of
// two convex solids is the hull of these.
struct DifferenceVertex {
    std::uint32_t p = 0;
    std::uint32_t q = 0;

    std::uint32_t of(std::size_t side) const noexcept { return side == 0 ? p : q; }
    friend bool operator==(const DifferenceVertex&, const DifferenceVertex&) = default;
};

}  // namespace ecods::depths
