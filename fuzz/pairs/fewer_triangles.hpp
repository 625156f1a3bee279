// Meshes with fewer triangles: a case that fails is made smaller, as long as it fails.
#pragma once

#include <memory>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::fuzz {

inline std::shared_ptr<const Mesh> without_first_triangle(const Mesh& mesh) {
    const auto triangles = mesh.triangles().subspan(1);
    return Mesh::create({mesh.vertices().begin(), mesh.vertices().end()}, {triangles.begin(), triangles.end()});
}

// `mesh` is a part of a case, which is changed while `fails` is asked, and is then the smallest that failed.
template <class Fails>
void drop_triangles(std::shared_ptr<const Mesh>& mesh, const Fails& fails) {
    for (std::size_t part = mesh->triangles().size() / 2; part > 0; part /= 2) {
        for (std::size_t from = 0; from < mesh->triangles().size() && mesh->triangles().size() > part;) {
            const std::shared_ptr<const Mesh> before = mesh;
            std::vector<Triangle> rest;
            for (std::size_t i = 0; i < before->triangles().size(); ++i) {
                if (i < from || i >= from + part) rest.push_back(before->triangles()[i]);
            }
            mesh = Mesh::create({before->vertices().begin(), before->vertices().end()}, std::move(rest));
            if (fails()) continue;
            mesh = before;
            from += part;
        }
    }
}

}  // namespace ecods::fuzz
