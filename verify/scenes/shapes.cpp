#include "scenes/shapes.hpp"

#include <cmath>
#include <numbers>

#include "scenes/mesh_builder.hpp"

namespace ecods::scenes {

namespace {

constexpr double tau = 2 * std::numbers::pi;

}  // namespace

std::shared_ptr<const Mesh> cube(double half) {
    std::vector<Vec3> vertices;
    for (int i = 0; i < 8; ++i) vertices.push_back({i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half});
    std::vector<Triangle> triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return Mesh::create(std::move(vertices), std::move(triangles));
}

std::shared_ptr<const Mesh> sphere(std::uint32_t around, std::uint32_t along) {
    MeshBuilder mesh;
    Ring last;
    const std::uint32_t south = mesh.add({0, 0, -1});
    for (std::uint32_t band = 1; band < along; ++band) {
        const double latitude = tau / 2 * band / along;
        std::vector<Vec3> circle;
        for (std::uint32_t i = 0; i < around; ++i) {
            const double angle = tau * i / around;
            circle.push_back(
                {std::sin(latitude) * std::cos(angle), std::sin(latitude) * std::sin(angle), -std::cos(latitude)});
        }
        const Ring ring = mesh.add_ring(circle);
        if (band == 1) {
            mesh.fan_from(south, ring);
        } else {
            mesh.bridge(last, ring);
        }
        last = ring;
    }
    mesh.fan_to(last, mesh.add({0, 0, 1}));
    return mesh.finish();
}

std::shared_ptr<const Mesh> torus(std::uint32_t around, std::uint32_t along, double tube) {
    MeshBuilder mesh;
    std::vector<Ring> rings;
    for (std::uint32_t i = 0; i < around; ++i) {
        const double angle = tau * i / around;
        std::vector<Vec3> circle;
        for (std::uint32_t k = 0; k < along; ++k) {
            const double turn = tau * k / along;
            const double distance = 1 + tube * std::cos(turn);
            // Negative, so that the circle turns counter-clockwise when seen against the direction of the tube.
            circle.push_back({distance * std::cos(angle), distance * std::sin(angle), -tube * std::sin(turn)});
        }
        rings.push_back(mesh.add_ring(circle));
    }
    for (std::uint32_t i = 0; i < around; ++i) mesh.bridge(rings[i], rings[(i + 1) % around]);
    return mesh.finish();
}

}  // namespace ecods::scenes
