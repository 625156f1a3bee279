// for_each_used_vertex visits the vertices of a mesh that belong to a triangle.
#pragma once

#include <cstdint>

#include "ecods/mesh.hpp"

namespace ecods {

// Calls visit(index) for each vertex that a triangle uses, in any order. A vertex may be visited more than once.
template <class Visit>
void for_each_used_vertex(const Mesh& mesh, const Visit& visit) {
    if (mesh.uses_all_vertices()) {
        for (std::uint32_t index = 0; index < mesh.vertices().size(); ++index) visit(index);
    } else {
        for (const Triangle& triangle : mesh.triangles()) {
            for (const std::uint32_t index : triangle) visit(index);
        }
    }
}

}  // namespace ecods
