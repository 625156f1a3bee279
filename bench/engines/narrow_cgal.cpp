// CGAL's Rigid_triangle_mesh_collision_detection. Each triangle is given vertices of its own, because the class takes
// manifold meshes, and meshes here are soups.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <memory>

#include "engines/narrow_engine.hpp"

namespace ecods::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Detection = CGAL::Rigid_triangle_mesh_collision_detection<SurfaceMesh>;

class NarrowCgal final : public Touch::Engine {
  public:
    explicit NarrowCgal(const scenes::MeshPairs& workload) {
        for (const scenes::NamedMesh& named : workload.meshes) {
            meshes_.push_back(std::make_unique<SurfaceMesh>());
            SurfaceMesh& surface = *meshes_.back();
            const std::span<const Vec3> vertices = named.mesh->vertices();
            for (const Triangle& t : named.mesh->triangles()) {
                const auto add = [&](std::uint32_t i) {
                    return surface.add_vertex({vertices[i].x(), vertices[i].y(), vertices[i].z()});
                };
                const auto a = add(t[0]), b = add(t[1]), c = add(t[2]);
                surface.add_face(a, b, c);
            }
            trees_.push_back(
                std::make_unique<Detection::AABB_tree>(faces(surface).begin(), faces(surface).end(), surface));
            trees_.back()->build();
            const auto one_part = CGAL::parameters::apply_per_connected_component(false);
            const std::size_t first = detection_.add_mesh(*trees_.back(), surface, one_part);
            ids_.push_back({first, detection_.add_mesh(*trees_.back(), surface, one_part)});
        }
    }

    double ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        const std::size_t a = placed(query.a, 0), b = placed(query.b, 1);
        return detection_.get_all_intersections(a, std::array{b}).empty() ? 0 : 1;
    }

  private:
    std::size_t placed(const scenes::MeshAt& at, std::size_t role) {
        const std::size_t id = ids_[at.mesh_index][role];
        const Mat3& R = at.pose.R;
        const Vec3& t = at.pose.t;
        detection_.set_transformation(
            id, CGAL::Aff_transformation_3<Kernel>(R(0, 0), R(0, 1), R(0, 2), t.x(), R(1, 0), R(1, 1), R(1, 2), t.y(),
                                                   R(2, 0), R(2, 1), R(2, 2), t.z()));
        return id;
    }

    std::vector<std::unique_ptr<SurfaceMesh>> meshes_;
    std::vector<std::unique_ptr<Detection::AABB_tree>> trees_;
    Detection detection_;
    std::vector<std::array<std::size_t, 2>> ids_;  // [mesh][role]: as the first and as the second of a pair
};

}  // namespace

std::vector<NarrowMaker> cgal_narrow() {
    return {{.name = "CGAL Rigid",
             .use = "Rigid_triangle_mesh_collision_detection over Epick, get_all_intersections(); predicates exact on "
                    "rounded vertices",
             .is_slow = true,
             .set_up = makes<NarrowCgal>()}};
}

}  // namespace ecods::bench
