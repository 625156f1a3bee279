// CGAL's Side_of_triangle_mesh and does_self_intersect().
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

#include "engines/side_engine.hpp"

namespace ecods::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Manifold = CGAL::Surface_mesh<Kernel::Point_3>;

Manifold manifold_of(const Mesh& mesh, const Pose& pose) {
    Manifold manifold;
    std::vector<Manifold::Vertex_index> vertices;
    for (const Vec3& v : mesh.vertices()) {
        const Vec3 p = pose.R * v + pose.t;
        vertices.push_back(manifold.add_vertex({p[0], p[1], p[2]}));
    }
    for (const Triangle& t : mesh.triangles()) manifold.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    return manifold;
}

}  // namespace

struct SideOfMesh::Parts {
    Parts(const Mesh& mesh, const Pose& pose) : manifold(manifold_of(mesh, pose)), side_of(manifold) {}

    Manifold manifold;
    CGAL::Side_of_triangle_mesh<Manifold, Kernel> side_of;
};

SideOfMesh::SideOfMesh(const Mesh& mesh, const Pose& pose) : parts_(std::make_unique<Parts>(mesh, pose)) {
    static_cast<void>(side(pose.t));  // which makes the tree
}
SideOfMesh::~SideOfMesh() = default;

Side SideOfMesh::side(const Vec3& point) const {
    const CGAL::Bounded_side side = parts_->side_of({point[0], point[1], point[2]});
    return side == CGAL::ON_BOUNDARY ? Side::on : side == CGAL::ON_BOUNDED_SIDE ? Side::inside : Side::outside;
}

struct ManifoldCgal::Parts {
    Manifold manifold;
};

ManifoldCgal::ManifoldCgal(const Mesh& mesh) : parts_(std::make_unique<Parts>(Parts{manifold_of(mesh, {})})) {}
ManifoldCgal::~ManifoldCgal() = default;

bool ManifoldCgal::does_self_intersect() const {
    return CGAL::Polygon_mesh_processing::does_self_intersect(parts_->manifold);
}

}  // namespace ecods::bench
