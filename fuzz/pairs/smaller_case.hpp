// Cases with fewer triangles or vertices: one that fails is made smaller, as long as it fails.
#pragma once

#include <memory>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/mesh.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "scenes/convex_cases.hpp"
#include "scenes/hit_cases.hpp"
#include "scenes/solid_cases.hpp"

namespace ecods::fuzz {

inline std::shared_ptr<const Mesh> without_triangles(const Mesh& mesh, std::size_t from, std::size_t count) {
    std::vector<Triangle> rest;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        if (i < from || i >= from + count) rest.push_back(mesh.triangles()[i]);
    }
    if (rest.empty()) return nullptr;
    return Mesh::create({mesh.vertices().begin(), mesh.vertices().end()}, std::move(rest));
}

// The hull of the mesh's vertices without some of them; nothing if these are in one plane.
inline std::shared_ptr<const Mesh> hull_without_vertices(const Mesh& mesh, std::size_t from, std::size_t count) {
    std::vector<Vec3> rest;
    for (std::size_t i = 0; i < mesh.vertices().size(); ++i) {
        if (i < from || i >= from + count) rest.push_back(mesh.vertices()[i]);
    }
    try {
        return convex_hull(rest);
    } catch (const NotSolid&) {
        return nullptr;
    }
}

// `mesh` is a part of a case, which is changed while `fails` is asked, and is then the smallest that failed. It has
// count_of(mesh) parts, of which `without` leaves some out, if it can.
template <class CountOf, class Without, class Fails>
void drop_parts(std::shared_ptr<const Mesh>& mesh, const CountOf& count_of, const Without& without,
                const Fails& fails) {
    for (std::size_t part = count_of(*mesh) / 2; part > 0; part /= 2) {
        for (std::size_t from = 0; from < count_of(*mesh);) {
            const std::shared_ptr<const Mesh> before = mesh;
            mesh = without(*before, from, part);
            if (mesh && fails()) continue;
            mesh = before;
            from += part;
        }
    }
}

template <class Fails>
void drop_triangles(std::shared_ptr<const Mesh>& mesh, const Fails& fails) {
    drop_parts(
        mesh, [](const Mesh& whole) { return whole.triangles().size(); }, without_triangles, fails);
}

template <class Fails>
void drop_vertices(std::shared_ptr<const Mesh>& mesh, const Fails& fails) {
    drop_parts(
        mesh, [](const Mesh& whole) { return whole.vertices().size(); }, hull_without_vertices, fails);
}

// `fails` is asked of the case while it changes.
template <class Fails>
void make_smaller(scenes::HitCase& made, const Fails& fails) {
    drop_triangles(made.mesh, fails);
}
template <class Fails>
void make_smaller(scenes::ConvexCase& made, const Fails& fails) {
    for (scenes::PosedMesh* body : {&made.a, &made.b}) drop_vertices(body->mesh, fails);
}
template <class Fails>
void make_smaller(scenes::SolidCase&, const Fails&) {}  // a solid without one of its triangles is none
template <class Case, class Fails>
void make_smaller(Case& made, const Fails& fails) {
    for (std::shared_ptr<const Mesh>* mesh : {&made.a, &made.b}) drop_triangles(*mesh, fails);
}

}  // namespace ecods::fuzz
