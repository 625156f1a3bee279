// Two meshes of one triangle each.
#pragma once

#include <optional>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/predicates.hpp"

namespace ecods {

// The relation of the posed triangles if plain doubles and one bound decide it: with neither trees nor anything that is
// made for a pair of bodies. Both meshes must have one triangle.
std::optional<Relation> filter_single_triangles(const Mesh& a, const Pose& pose_a, const Mesh& b,
                                                const Pose& pose_b) noexcept;

}  // namespace ecods
