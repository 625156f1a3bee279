#include "fuzz/base/mesh_form.hpp"

#include "ecods/error.hpp"
#include "ecods/rounded.hpp"

namespace ecods::fuzz {

MeshForm form_of(const Shape& shape) noexcept {
    if (const auto* rounded = dynamic_cast<const Rounded*>(&shape)) return rounded->core().form();
    const auto* const of_mesh = dynamic_cast<const MeshShape*>(&shape);
    return of_mesh != nullptr ? of_mesh->form() : MeshForm::surface;
}

double radius_of(const Shape& shape) noexcept {
    const auto* rounded = dynamic_cast<const Rounded*>(&shape);
    return rounded != nullptr ? rounded->radius() : 0;
}

int dimension_of(const Shape& shape) noexcept {
    const auto* const rounded = dynamic_cast<const Rounded*>(&shape);
    const Shape* const core = rounded != nullptr ? &rounded->core() : &shape;
    const auto* const convex = dynamic_cast<const ConvexSolid*>(core);
    return convex != nullptr ? convex->dimension() : 3;
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
