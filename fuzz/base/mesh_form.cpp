#include "fuzz/base/mesh_form.hpp"

#include "ecods/error.hpp"

namespace ecods::fuzz {

MeshForm form_of(const Shape& shape) noexcept {
    const auto* const of_mesh = dynamic_cast<const MeshShape*>(&shape);
    return of_mesh != nullptr ? of_mesh->form() : MeshForm::surface;
}

bool has_form(const std::shared_ptr<const Mesh>& mesh, MeshForm form) {
    try {
        make_shape(mesh, form);
        return true;
    } catch (const NotSolid&) {
    }
    return false;
}

}  // namespace ecods::fuzz
