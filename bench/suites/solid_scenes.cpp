#include "suites/solid_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenes/flush_parts.hpp"
#include "scenes/shapes.hpp"

namespace ecods::bench {

std::shared_ptr<const Mesh> slab(std::uint32_t n, double height, bool other_diagonals) {
    const std::shared_ptr<const Mesh> plate = scenes::plate(n, 1);
    std::vector<Vec3> vertices;
    for (const double z : {0.0, height}) {
        for (std::uint32_t x = 0; x <= n; ++x) {
            for (std::uint32_t y = 0; y <= n; ++y) vertices.emplace_back(x, y, z);
        }
    }
    std::vector<Triangle> triangles(plate->triangles().begin(), plate->triangles().end());
    for (std::size_t i = 0; i < triangles.size() && other_diagonals; i += 2) {
        const auto [a, b, c] = triangles[i];
        const std::uint32_t d = triangles[i + 1][2];
        triangles[i] = {b, c, d};
        triangles[i + 1] = {b, d, a};
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

std::vector<SolidScene> solid_scenes(std::uint32_t triangle_count) {
    const auto around = static_cast<std::uint32_t>(std::sqrt(triangle_count));
    const auto n = static_cast<std::uint32_t>(std::sqrt(triangle_count / 4));
    const auto solid = [](std::shared_ptr<const Mesh> mesh) { return std::make_shared<const Solid>(std::move(mesh)); };
    const auto sphere = solid(scenes::sphere(around, around / 2)),
               ring = solid(scenes::torus(around, around / 2, 0.25));
    const auto thick = solid(slab(n, 8)), thin = solid(slab(n, 4)), other = solid(slab(n, 8, true));

    scenes::Random random(1);
    std::vector<SolidScene> all;
    const auto add_round = [&](const char* name, const auto& a, const auto& b, const Vec3& t, double size,
                               Relation relation) {
        SolidScene scene{name, a, b, {}, {}, relation, false};
        scene.pose_a.R = random.rotation().toRotationMatrix();
        scene.pose_b.R = size * random.rotation().toRotationMatrix();
        scene.pose_b.t = scene.pose_a.R * t;
        all.push_back(std::move(scene));
    };
    add_round("spheres beside each other", sphere, sphere, Vec3(1.2, 1.2, 1.2), 1, Relation::apart);
    add_round("sphere in a ring's hole", ring, sphere, Vec3(0, 0, 0), 0.5, Relation::apart);
    add_round("sphere in a sphere", sphere, sphere, Vec3(0.25, 0, 0), 0.5, Relation::contains);
    add_round("sphere in a ring", ring, sphere, Vec3(1, 0, 0), 0.125, Relation::contains);
    // An integer matrix: images of lattice points are exact.
    Pose turned;
    turned.R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
    const auto add_slabs = [&](const char* name, const auto& a, const auto& b, const Vec3& t, Relation relation) {
        SolidScene scene{name, a, b, turned, turned, relation, true};
        scene.pose_b.t = turned.R * t;
        all.push_back(std::move(scene));
    };
    add_slabs("slab on a slab, half a cell off", thick, thick, Vec3(0.5, 0.5, 8), Relation::touching);
    add_slabs("slab on a slab, one edge over it", thick, thick, Vec3(n, 0, 8), Relation::touching);
    add_slabs("thin slab in a thick one, flush", thick, thin, Vec3(0, 0, 0), Relation::contains);
    add_slabs("equal slabs, other diagonals", thick, other, Vec3(0, 0, 0), Relation::equal);
    add_slabs("walls that share a part, flush", thick, thick, Vec3(n / 2, 0, 0), Relation::overlapping);
    return all;
}

std::vector<PointScene> point_scenes(const Mesh& mesh, std::size_t point_count) {
    scenes::Random random(2);
    Pose turned = random.turned();
    turned.t = Vec3(0.5, 0.25, -0.125);
    std::vector<PointScene> all = {{"random, in its box", turned, {}, true},
                                   {"near, at 1e-3", turned, {}, true},
                                   {"nearly on, at 1e-12", turned, {}, false},
                                   {"far", turned, {}, false},
                                   {"on vertices", {}, {}, false},
                                   {"on edges", {}, {}, false}};
    const auto triangles = mesh.triangles();
    Vec3 low = mesh.vertices()[0], high = low;
    for (const Vec3& v : mesh.vertices()) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    for (std::size_t i = 0; i < point_count; ++i) {
        const Triangle& t = triangles[random.below(static_cast<std::uint32_t>(triangles.size()))];
        const auto corner = [&](std::size_t k) -> const Vec3& { return mesh.vertices()[t[k]]; };
        const double s = random.uniform(0, 1), r = random.uniform(0, 1 - s);
        const Vec3 inner = corner(0) + s * (corner(1) - corner(0)) + r * (corner(2) - corner(0));
        const Vec3 away = random.direction(), on = turned.R * inner + turned.t;
        Vec3 boxed;
        for (int k = 0; k < 3; ++k) boxed[k] = random.uniform(low[k], high[k]);
        all[0].points.push_back(turned.R * boxed + turned.t);
        all[1].points.push_back(on + 1e-3 * away);
        all[2].points.push_back(on + 1e-12 * away);
        all[3].points.push_back(turned.t + random.uniform(2, 10) * away);
        all[4].points.push_back(corner(0));
        all[5].points.push_back(0.5 * corner(0) + 0.5 * corner(1));
    }
    return all;
}

}  // namespace ecods::bench
