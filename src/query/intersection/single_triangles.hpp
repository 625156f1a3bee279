// Decides the relation of a single pair of triangles without any preparation. Each triangle is given by a mesh at a
// pose.
#pragma once

#include <cstdint>
#include <optional>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Returns the relation of triangle i of a and triangle j of b if doubles with one error bound decide it; otherwise
// nullopt. The function needs no trees, and no other preparation of the bodies.
std::optional<Relation> filter_triangles(const Mesh& a, std::uint32_t i, const Pose& pose_a, const Mesh& b,
                                         std::uint32_t j, const Pose& pose_b) noexcept;

}  // namespace ecods
