#include "scenes/flush_parts.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "ecods/intersection.hpp"
#include "scenes/mesh_builder.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

namespace {

// A turn about z by an even angle, without sines: a random direction in the plane.
Mat3 turn_about_z(Random& random) {
    Vec3 x = random.direction();
    while (x.x() * x.x() + x.y() * x.y() < 0.25) x = random.direction();
    const double length = std::sqrt(x.x() * x.x() + x.y() * x.y());
    const double c = x.x() / length, s = x.y() / length;
    Mat3 turn;
    turn << c, -s, 0, s, c, 0, 0, 0, 1;
    return turn;
}

}  // namespace

std::shared_ptr<const Mesh> plate(std::uint32_t cells, double height) {
    MeshBuilder mesh;
    const auto place = [&](std::uint32_t i) { return 2.0 * i / cells - 1; };
    const auto at = [&](std::uint32_t i, std::uint32_t k, bool is_upper) {
        return (is_upper ? (cells + 1) * (cells + 1) : 0) + i * (cells + 1) + k;
    };
    for (const double z : {-height, height})
        for (std::uint32_t i = 0; i <= cells; ++i)
            for (std::uint32_t k = 0; k <= cells; ++k) mesh.add({place(i), place(k), z});
    for (std::uint32_t i = 0; i < cells; ++i) {
        for (std::uint32_t k = 0; k < cells; ++k) {
            mesh.add_quad(at(i, k, false), at(i, k + 1, false), at(i + 1, k + 1, false), at(i + 1, k, false));
            mesh.add_quad(at(i, k, true), at(i + 1, k, true), at(i + 1, k + 1, true), at(i, k + 1, true));
        }
        mesh.add_quad(at(i, 0, false), at(i + 1, 0, false), at(i + 1, 0, true), at(i, 0, true));
        mesh.add_quad(at(i, cells, false), at(i, cells, true), at(i + 1, cells, true), at(i + 1, cells, false));
        mesh.add_quad(at(0, i, false), at(0, i, true), at(0, i + 1, true), at(0, i + 1, false));
        mesh.add_quad(at(cells, i, false), at(cells, i + 1, false), at(cells, i + 1, true), at(cells, i, true));
    }
    return mesh.finish();
}

MeshPairs flush_plates(const std::string& name, std::uint32_t cells, double height, std::size_t count,
                       std::uint32_t seed) {
    const auto mesh = plate(cells, height);
    const double top = mesh->vertices().back().z();  // on the grid
    MeshPairs pairs{name, {{name, mesh}}, {}};
    Random random(seed);
    while (pairs.queries.size() < count) {
        Pose a = random.turned();
        for (int axis = 0; axis < 3; ++axis) a.t[axis] = random.uniform(-4, 4);
        Pose b = a;
        const double x = random.uniform(-1.5, 1.5), y = random.uniform(-1.5, 1.5);
        b.t += (a.R.col(0) * x + a.R.col(1) * y) + a.R.col(2) * (2 * top);
        pairs.queries.push_back({{0, a}, {0, b}});
    }
    return pairs;
}

std::shared_ptr<const Mesh> flat_polygon(std::uint32_t corners) {
    std::vector<Vec3> vertices;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        vertices.push_back(on_grid(Vec3(std::cos(angle), std::sin(angle), 0)));
    }
    std::vector<Triangle> triangles;
    for (std::uint32_t low = 0, high = corners - 1; high - low > 1;) {
        triangles.push_back({low, low + 1, high});
        ++low;
        if (high - low <= 1) break;
        triangles.push_back({low, high - 1, high});
        --high;
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

MeshPairs flat_polygons(std::uint32_t corners, std::size_t count, std::uint32_t seed) {
    const std::string name = std::to_string(corners) + "-gons in one plane";
    const auto mesh = flat_polygon(corners);
    const MeshShape shape(mesh);
    QueryMemory memory;
    MeshPairs pairs{name, {{name, mesh}}, {}};
    Random random(seed);
    while (pairs.queries.size() < count) {
        const Pose a{turn_about_z(random), Vec3::Zero()};
        const Mat3 turn = turn_about_z(random);
        const Vec3 line = turn_about_z(random).col(0);
        const auto at = [&](double distance) { return Pose{turn, line * distance}; };
        const auto hits = [&](double distance) { return intersects({shape, a}, {shape, at(distance)}, memory); };
        double hit = 1, miss = 3;
        while (miss - hit > 0x1p-20) {
            const double middle = (hit + miss) / 2;
            (hits(middle) ? hit : miss) = middle;
        }
        const double gap = std::ldexp(1.0, -7 - static_cast<int>(random.below(7)));
        pairs.queries.push_back({{0, a}, {0, at(pairs.queries.size() % 2 == 0 ? hit - gap : miss + gap)}});
    }
    return pairs;
}

std::shared_ptr<const Mesh> one_triangle() {
    return Mesh::create({{1, 0, 0}, {-0.5, 0.75, 0.125}, {-0.375, -0.875, -0.25}}, {{0, 1, 2}});
}

}  // namespace ecods::scenes
