// As what a body's shape is a mesh: a surface, a solid or a convex solid. A trace says it, since answers depend on it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "ecods/mesh.hpp"
#include "ecods/shape.hpp"

namespace ecods {

enum class MeshForm : std::uint8_t { surface, solid, convex };

// By form: the first word of the line.
inline constexpr std::array<std::string_view, 3> mesh_form_names = {"mesh", "solid", "convex"};

std::optional<MeshForm> parse_mesh_form(std::string_view name);

MeshForm form_of(const MeshShape& shape) noexcept;

// A new shape. Throws where the mesh has not got this form.
std::shared_ptr<const MeshShape> make_shape(const std::shared_ptr<const Mesh>& mesh, MeshForm form);

}  // namespace ecods
