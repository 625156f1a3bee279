#include "trace/mesh_form.hpp"

#include <algorithm>

#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

namespace ecods {

std::optional<MeshForm> parse_mesh_form(std::string_view name) {
    const auto* const found = std::ranges::find(mesh_form_names, name);
    if (found == mesh_form_names.end()) return std::nullopt;
    return static_cast<MeshForm>(found - mesh_form_names.begin());
}

std::shared_ptr<const MeshShape> make_shape(const std::shared_ptr<const Mesh>& mesh, MeshForm form) {
    switch (form) {
        case MeshForm::convex:
            return std::make_shared<const ConvexSolid>(mesh);
        case MeshForm::solid:
            return std::make_shared<const Solid>(mesh);
        case MeshForm::surface:
            break;
    }
    return std::make_shared<const MeshShape>(mesh);
}

}  // namespace ecods
