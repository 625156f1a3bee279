// Two triangles, each of a mesh at a pose, of which nothing else is asked.
#pragma once

#include <cstdint>
#include <optional>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/predicates.hpp"

namespace ecods {

// The relation of triangle i of a and j of b if plain doubles and one bound decide it: with neither trees nor anything
// that is made for a pair of bodies.
std::optional<Relation> filter_triangles(const Mesh& a, std::uint32_t i, const Pose& pose_a, const Mesh& b,
                                         std::uint32_t j, const Pose& pose_b) noexcept;

}  // namespace ecods
