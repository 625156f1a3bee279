// The vertices of a mesh that its triangles have.
#pragma once

#include <cstdint>

#include "ecods/mesh.hpp"

namespace ecods {

// Calls visit(v) for each vertex that is a corner of a triangle: once where all vertices are, otherwise for each
// corner.
template <class Visit>
void for_each_used_vertex(const Mesh& mesh, Visit&& visit) {
    const auto vertices = mesh.vertices();
    if (mesh.uses_all_vertices()) {
        for (const Vec3& v : vertices) visit(v);
        return;
    }
    for (const Triangle& triangle : mesh.triangles()) {
        for (const std::uint32_t index : triangle) visit(vertices[index]);
    }
}

}  // namespace ecods
