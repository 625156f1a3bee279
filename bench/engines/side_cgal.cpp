// CGAL's Side_of_triangle_mesh and does_self_intersect().
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <memory>
#include <vector>

#include "engines/side_engine.hpp"

namespace ecods::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Manifold = CGAL::Surface_mesh<Kernel::Point_3>;

std::shared_ptr<Manifold> manifold_of(const Mesh& mesh, const Pose& pose) {
    const auto manifold = std::make_shared<Manifold>();
    std::vector<Manifold::Vertex_index> vertices;
    for (const Vec3& v : mesh.vertices()) {
        const Vec3 p = pose.R * v + pose.t;
        vertices.push_back(manifold->add_vertex({p[0], p[1], p[2]}));
    }
    for (const Triangle& t : mesh.triangles()) manifold->add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    return manifold;
}

}  // namespace

std::function<Side(const Vec3& point)> side_of_mesh_by_cgal(const Mesh& mesh, const Pose& pose) {
    const auto manifold = manifold_of(mesh, pose);
    const auto side_of = std::make_shared<CGAL::Side_of_triangle_mesh<Manifold, Kernel>>(*manifold);
    const auto side = [manifold, side_of](const Vec3& point) {
        const CGAL::Bounded_side found = (*side_of)({point[0], point[1], point[2]});
        return found == CGAL::ON_BOUNDARY ? Side::on : found == CGAL::ON_BOUNDED_SIDE ? Side::inside : Side::outside;
    };
    static_cast<void>(side(pose.t));  // which makes the tree
    return side;
}

std::function<bool()> self_intersection_by_cgal(const Mesh& mesh) {
    return [manifold = manifold_of(mesh, {})] { return CGAL::Polygon_mesh_processing::does_self_intersect(*manifold); };
}

}  // namespace ecods::bench
