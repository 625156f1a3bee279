// Names the forms of meshes in a trace. A trace must state the form, because answers depend on it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "ecods/mesh.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Lists, by form, the first word of a mesh's line in a trace.
inline constexpr std::array<std::string_view, 3> mesh_form_names = {"mesh", "solid", "convex"};

std::optional<MeshForm> parse_mesh_form(std::string_view name);

// Returns a new shape of this form. Throws NotSolid if the mesh cannot have the form.
std::shared_ptr<const MeshShape> make_shape(const std::shared_ptr<const Mesh>& mesh, MeshForm form);

}  // namespace ecods
