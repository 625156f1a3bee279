#include "fuzz/meshes.hpp"

#include <utility>
#include <vector>

#include "scenes/shapes.hpp"

namespace ecods::fuzz {
namespace {

Vec3 lattice_point(scenes::Random& random, std::uint32_t side = 3) {
    return Vec3(random.below(side), random.below(side), random.below(side));
}

Vec3 any_point(scenes::Random& random) {
    return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
}

const std::vector<Triangle> tetrahedron = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};

}  // namespace

std::shared_ptr<const Mesh> make_mesh(double unit, scenes::Random& random, Counters& counters) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles = {{0, 1, 2}};
    const char* name = "";
    switch (random.below(8)) {
        case 0:
            name = "lattice tetrahedron";
            for (int i = 0; i < 4; ++i) vertices.push_back(lattice_point(random));
            triangles = tetrahedron;
            break;
        case 1: {
            name = "cube";
            const auto cube = scenes::cube(random.below(2) == 0 ? 0.5 : 1);
            vertices.assign(cube->vertices().begin(), cube->vertices().end());
            triangles.assign(cube->triangles().begin(), cube->triangles().end());
            break;
        }
        case 2: {
            name = "lattice soup";
            for (int i = 0; i < 6; ++i) vertices.push_back(lattice_point(random));
            triangles.clear();
            for (std::uint32_t i = 0, count = 1 + random.below(5); i < count; ++i) {
                triangles.push_back({random.below(6), random.below(6), random.below(6)});
            }
            break;
        }
        case 3: {
            name = "zero area";
            const Vec3 from = lattice_point(random);
            const Vec3 step = random.below(3) == 0 ? Vec3(0, 0, 0) : lattice_point(random);
            for (int i = 0; i < 3; ++i) vertices.push_back(from + random.below(3) * step);
            break;
        }
        case 4:
            name = "sliver";
            vertices = {Vec3(0, 0, 0), Vec3(2, 1, 0), Vec3(1, 0.5, 0x1p-50)};
            break;
        case 5:
            name = "decimals";
            for (int i = 0; i < 4; ++i) vertices.push_back(0.1 * lattice_point(random, 11));
            triangles = tetrahedron;
            break;
        default:
            name = "any doubles";
            for (int i = 0; i < 4; ++i) vertices.push_back(any_point(random));
            triangles = tetrahedron;
            break;
    }
    ++counters[name];
    for (Vec3& vertex : vertices) vertex *= unit;
    return Mesh::create(std::move(vertices), std::move(triangles));
}

}  // namespace ecods::fuzz
