#include "fuzz/motion/meshes.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/base/failure.hpp"
#include "fuzz/base/recipe.hpp"
#include "judge/whether_solid.hpp"
#include "scenes/cells.hpp"
#include "scenes/lattice_mesh.hpp"
#include "scenes/shapes.hpp"

namespace ecods::fuzz {
namespace {

using scenes::Random;

struct Soup {
    const char* name;
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

Vec3 lattice_point(Random& random, std::uint32_t side = 3) {
    // Arguments of one call would be drawn in an order that the compiler chooses.
    Vec3 point;
    for (double& x : point) x = random.below(side);
    return point;
}

Vec3 any_point(double reach, Random& random) {
    Vec3 point;
    for (double& x : point) x = random.uniform(-reach, reach);
    return point;
}

const std::vector<Triangle> tetrahedron = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};

Soup soup_of(const char* name, const Mesh& mesh) {
    return {name, {mesh.vertices().begin(), mesh.vertices().end()}, {mesh.triangles().begin(), mesh.triangles().end()}};
}

Soup lattice_soup(Random& random) {
    Soup soup{"lattice soup", {}, {}};
    for (int i = 0; i < 6; ++i) soup.vertices.push_back(lattice_point(random));
    for (std::uint32_t i = 0, count = 1 + random.below(5); i < count; ++i) {
        Triangle& triangle = soup.triangles.emplace_back();
        for (std::uint32_t& corner : triangle) corner = random.below(6);
    }
    return soup;
}

Soup zero_area(Random& random) {
    const Vec3 from = lattice_point(random);
    const Vec3 step = random.below(3) == 0 ? Vec3(0, 0, 0) : lattice_point(random);
    Soup soup{"zero area", {}, {{0, 1, 2}}};
    for (int i = 0; i < 3; ++i) soup.vertices.push_back(from + random.below(3) * step);
    return soup;
}

Soup sliver(Random& random) {
    // Thin by 2^-1 to 2^-50.
    const double height = std::ldexp(1.0, -1 - static_cast<int>(random.below(50)));
    return {"sliver", {Vec3(0, 0, 0), Vec3(2, 1, 0), Vec3(1, 0.5, height)}, {{0, 1, 2}}};
}

Soup four_points(const char* name, Random& random) {
    Soup soup{name, {}, tetrahedron};
    for (int i = 0; i < 4; ++i) {
        soup.vertices.push_back(name[0] == 'l'   ? lattice_point(random)
                                : name[0] == 'd' ? Vec3(0.1 * lattice_point(random, 11))
                                                 : any_point(1, random));
    }
    return soup;
}

Soup hard_soup(Random& random) {
    switch (random.below(8)) {
        case 0:
            return four_points("lattice tetrahedron", random);
        case 1:
            return soup_of("cube", *scenes::cube(random.below(2) == 0 ? 0.5 : 1));
        case 2:
            return lattice_soup(random);
        case 3:
            return zero_area(random);
        case 4:
            return sliver(random);
        case 5:
            return four_points("decimals", random);
        default:
            return four_points("any doubles", random);
    }
}

Soup cubes_soup(Random& random) {
    Soup soup = soup_of("cube", *scenes::cube(0.5));
    if (random.below(4) == 0) {
        soup.name = "brick";
        for (Vec3& vertex : soup.vertices) vertex[0] *= 2;
    }
    return soup;
}

Soup round_soup(Random& random) {
    switch (random.below(3)) {
        case 0:
            return soup_of("sphere", *scenes::sphere(8, 4));
        case 1:
            return soup_of("torus", *scenes::torus(16, 8, 0.25));
        default:
            return soup_of("sphere, finer", *scenes::sphere(12, 8));
    }
}

Soup of_cells(const char* name, const scenes::Cells& cells, Random& random) {
    const scenes::LatticeMesh mesh = scenes::boundary(cells, true, random);
    Soup soup{name, {}, mesh.triangles};
    for (const auto& [x, y, z] : mesh.vertices) soup.vertices.push_back(0.5 * Vec3(x, y, z) - Vec3(0.5, 0.5, 0.5));
    return soup;
}

// A set of cells, and a cube of 27 without that in its middle.
Soup polycube(Random& random) {
    static const std::vector<scenes::Cells> all = scenes::polycubes(4);
    return of_cells("polycube", all[random.below(static_cast<std::uint32_t>(all.size()))], random);
}
Soup hollow_cube(Random& random) {
    scenes::Cells cells;
    for (int i = 0; i < 27; ++i) {
        if (i != 13) cells.push_back({i / 9, i / 3 % 3, i % 3});
    }
    return of_cells("hollow cube", cells, random);
}

Soup octahedron() {
    Soup soup{"octahedron", {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        soup.vertices.push_back(0.5 * Vec3::Unit(axis));
        soup.vertices.push_back(-0.5 * Vec3::Unit(axis));
    }
    for (std::uint32_t i = 0; i < 8; ++i) soup.triangles.push_back({i % 2, 2 + i / 2 % 2, 4 + i / 4});
    return soup;
}

// A square, a segment or a point: convex solids that are flat.
Soup flat_soup(Random& random) {
    Soup soup{"flat", {}, {}};
    for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) soup.vertices.push_back({x, y, 0});
    }
    switch (random.below(3)) {
        case 0:
            soup.triangles = {{0, 0, 0}};
            break;
        case 1:
            soup.triangles = {{0, 3, 3}};
            break;
        default:
            soup.triangles = {{0, 2, 3}, {0, 3, 1}};
    }
    return soup;
}

// Every one of these but the flat ones bounds a solid, before it is scaled.
Soup solid_soup(Random& random) {
    switch (random.below(8)) {
        case 0:
            return soup_of("cube", *scenes::cube(0.5));
        case 1:
            return hollow_cube(random);
        case 2:
            return octahedron();
        case 3:
            return soup_of("sphere", *scenes::sphere(5, 3));
        case 4:
        case 5:
            return polycube(random);
        case 6:
            return flat_soup(random);
        default:
            return cubes_soup(random);
    }
}

}  // namespace

void require_solid(const std::string& name, const Mesh& mesh) {
    const judge::WhetherSolid whether(mesh);
    if (!whether.is_solid()) throw CheckFailed(recipe_check, name + " bounds a solid", whether.words());
}

std::shared_ptr<const Mesh> make_mesh(Meshes menu, double unit, Random& random, Counters& counters) {
    Soup soup = menu == Meshes::hard    ? hard_soup(random)
                : menu == Meshes::cubes ? cubes_soup(random)
                : menu == Meshes::round ? round_soup(random)
                                        : solid_soup(random);
    ++counters[std::string("meshes: ") + soup.name];
    if (menu == Meshes::solids && std::string_view(soup.name) != "flat")
        require_solid(soup.name, *Mesh::create(soup.vertices, soup.triangles));
    for (Vec3& vertex : soup.vertices) vertex *= unit;
    return Mesh::create(std::move(soup.vertices), std::move(soup.triangles));
}

std::shared_ptr<const Mesh> deformed(const Mesh& mesh, double unit, Random& random) {
    std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
    const std::uint32_t how = random.below(4);
    const auto axis = static_cast<int>(random.below(3));
    for (Vec3& vertex : vertices) {
        if (how == 0) vertex += any_point(0.1 * unit, random);
        if (how == 1) vertex += any_point(unit, random);
        if (how == 2) vertex[axis] = 0;
        if (how == 3) vertex += unit * lattice_point(random, 2);
    }
    return Mesh::create(std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()});
}

}  // namespace ecods::fuzz
