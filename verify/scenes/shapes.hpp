// Small meshes to try things with. All but one triangle are closed, seen counter-clockwise from outside; all are the
// same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

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

inline std::shared_ptr<const Mesh> one_triangle(const std::array<Vec3, 3>& corners) {
    return Mesh::create({corners.begin(), corners.end()}, {{0, 1, 2}});
}

}  // namespace ecods::scenes
