#include "scenes/lattice_bodies.hpp"

#include <vector>

#include "scenes/shapes.hpp"

namespace ecods::scenes {

using hard::integer;

Vec3 lattice_point(Random& random, int size) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = integer(random, -size, size);
    return p;
}

std::shared_ptr<const Mesh> lattice_mesh(Random& random, int size, int triangles_max, bool is_flat) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    const auto vertex_count = static_cast<std::uint32_t>(integer(random, 3, 6));
    for (std::uint32_t i = 0; i < vertex_count; ++i) {
        vertices.push_back(lattice_point(random, size));
        if (is_flat) vertices.back()[2] = 0;
    }
    for (int i = integer(random, 1, triangles_max); i > 0; --i) {
        Triangle t;
        for (std::uint32_t& index : t) index = random.below(vertex_count);
        triangles.push_back(t);
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

Vec3 in_basis(const Vec3& v, const hard::Basis& basis) {
    return v[0] * basis.vectors[0] + v[1] * basis.vectors[1] + v[2] * basis.vectors[2];
}

std::shared_ptr<const Mesh> in_basis(const Mesh& mesh, const hard::Basis& basis) {
    return mapped(mesh, [&](const Vec3& v) { return in_basis(v, basis); });
}

Mat3 integer_entries(Random& random, int size) {
    Mat3 R;
    for (int i = 0; i < 9; ++i) R.data()[i] = integer(random, -size, size);
    return R;
}

std::shared_ptr<const Mesh> lattice_box(Random& random) {
    const Vec3 corner = lattice_point(random, 2);
    Vec3 size;
    for (int k = 0; k < 3; ++k) size[k] = integer(random, 1, 3);
    return mapped(*cube(0.5),
                  [&](const Vec3& v) -> Vec3 { return corner + Vec3(size.cwiseProduct(v + Vec3(0.5, 0.5, 0.5))); });
}

Vec3 any_corner(const Mesh& mesh, const Pose& pose, Random& random) {
    const Triangle& t = mesh.triangles()[random.below(static_cast<std::uint32_t>(mesh.triangles().size()))];
    const auto corner = [&] { return mesh.vertices()[t[random.below(3)]]; };
    Vec3 v = corner();
    if (random.below(3) == 0) v = 0.5 * (v + corner());
    if (random.below(4) == 0) v = 0.75 * v + 0.25 * corner();
    return pose.R * v + pose.t;
}

}  // namespace ecods::scenes
