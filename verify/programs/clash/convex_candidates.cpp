#include "programs/clash/convex_candidates.hpp"

#include <algorithm>
#include <limits>

#include "ecods/broad_phase.hpp"
#include "ecods/primitives.hpp"
#include "process/parallel.hpp"

namespace ecods::clash {
namespace {

// Whether one of the triangles, as far as they are looked at, has vertices on both sides of its plane: then the mesh
// bounds no convex solid, which costs less to find out here than from the exact check.
//
// A determinant is computed with an error of at most 8 u times the sum of the magnitudes of its six products (Shewchuk
// 1997, bound A of orient3d: (7 + 56 u) u), each of which is at most e^3 for the mesh's largest extent e: 48 u e^3.
bool has_dent(const Mesh& mesh) {
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    constexpr std::size_t work_limit = std::size_t{1} << 20;
    const auto vertices = mesh.vertices();
    Vec3 min = vertices[0];
    Vec3 max = vertices[0];
    for (const Vec3& v : vertices) {
        min = min.cwiseMin(v);
        max = max.cwiseMax(v);
    }
    const double extent = (max - min).maxCoeff();
    const double bound = 64 * u * extent * extent * extent;
    const std::size_t triangle_count = std::min(mesh.triangles().size(), work_limit / vertices.size() + 1);
    for (const Triangle& t : mesh.triangles().first(triangle_count)) {
        const Vec3& a = vertices[t[0]];
        const Vec3 normal = (vertices[t[1]] - a).cross(vertices[t[2]] - a);
        double least = 0;
        double most = 0;
        for (const Vec3& v : vertices) {
            const double height = normal.dot(v - a);
            least = std::min(least, height);
            most = std::max(most, height);
        }
        if (least < -bound && most > bound) return true;
    }
    return false;
}

// A box that holds the body: of one that is not moved the least one around all vertices.
Aabb box_of_body(const scenes::Scene& scene, const scenes::SceneBody& body) {
    const Mesh& mesh = *scene.meshes[body.mesh_index].mesh;
    if (!(body.pose == Pose{})) return box_of(mesh, body.pose);
    Aabb box{mesh.vertices()[0], mesh.vertices()[0]};
    for (const Vec3& v : mesh.vertices()) box = {box.min.cwiseMin(v), box.max.cwiseMax(v)};
    return box;
}

}  // namespace

std::vector<char> find_convex_candidates(const scenes::Scene& scene, std::size_t jobs) {
    std::vector<char> is_dented(scene.meshes.size());
    process::for_each_in_parallel(scene.meshes.size(), jobs, [&](std::size_t i, std::size_t) {
        is_dented[i] = has_dent(*scene.meshes[i].mesh) ? 1 : 0;
    });
    const auto broad_phase = make_broad_phase(BroadPhaseKind::kept_candidates);
    broad_phase->reserve(scene.bodies.size());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (is_dented[scene.bodies[i].mesh_index] == 0)
            broad_phase->add(static_cast<ProxyIndex>(i), box_of_body(scene, scene.bodies[i]));
    }
    std::vector<char> candidates(scene.meshes.size());
    broad_phase->visit_near_pairs(0, [&](ProxyPair pair) {
        const Aabb a = broad_phase->box(pair.a);
        const Aabb b = broad_phase->box(pair.b);
        const bool share_inner_points = (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
        if (share_inner_points) {
            candidates[scene.bodies[pair.a].mesh_index] = 1;
            candidates[scene.bodies[pair.b].mesh_index] = 1;
        }
        return 0.0;
    });
    return candidates;
}

}  // namespace ecods::clash
