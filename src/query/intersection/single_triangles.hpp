// Decides a single pair of triangles, each of a mesh at a pose, without any preparation.
#pragma once

#include <cstdint>
#include <optional>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/predicates.hpp"

namespace ecods {

// The relation of triangle i of a and j of b if plain doubles with one bound decide it; otherwise nullopt. It needs no
// trees, and nothing that is made for a pair of bodies.
std::optional<Relation> filter_triangles(const Mesh& a, std::uint32_t i, const Pose& pose_a, const Mesh& b,
                                         std::uint32_t j, const Pose& pose_b) noexcept;

}  // namespace ecods
