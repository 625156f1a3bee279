// Small meshes to try things with. All but one triangle are closed, seen counter-clockwise from outside; all are the
// same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::scenes {

// The cube [-half, half]^3: 8 vertices, 12 triangles.
std::shared_ptr<const Mesh> cube(double half);

// The unit sphere by circles of latitude: `around` vertices on each, `along` bands from pole to pole; around >= 3,
// along >= 2. around * (along - 1) + 2 vertices, 2 * around * (along - 1) triangles. Vertices are rounded to 2^-20.
std::shared_ptr<const Mesh> sphere(std::uint32_t around, std::uint32_t along);

// A torus about the z axis whose tube, of radius `tube`, has its centre at distance 1; around, along >= 3.
// around * along vertices, twice as many triangles. Vertices are rounded to 2^-20.
std::shared_ptr<const Mesh> torus(std::uint32_t around, std::uint32_t along, double tube);

// The mesh with its vertices mapped, one by one.
template <class Map>
std::shared_ptr<const Mesh> mapped(const Mesh& mesh, Map map) {
    std::vector<Vec3> vertices;
    for (const Vec3& v : mesh.vertices()) vertices.push_back(map(v));
    return Mesh::create(std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()});
}

// The mesh with its axes exchanged in a circle, so that z becomes this one.
inline std::shared_ptr<const Mesh> across(const Mesh& mesh, int axis) {
    return mapped(mesh, [axis](const Vec3& v) {
        Vec3 w;
        for (int k = 0; k < 3; ++k) w[(axis + 1 + k) % 3] = v[k];
        return w;
    });
}

inline std::shared_ptr<const Mesh> one_triangle(const std::array<Vec3, 3>& corners) {
    return Mesh::create({corners.begin(), corners.end()}, {{0, 1, 2}});
}

}  // namespace ecods::scenes
