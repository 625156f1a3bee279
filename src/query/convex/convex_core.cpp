#include "query/convex/convex_core.hpp"

#include <memory>

namespace ecods::convex {

bool is_convex_core(const MeshShape& shape) noexcept {
    return shape.form() == MeshForm::convex || shape.mesh().triangles().size() == 1;
}

Posed<ConvexSolid> convex_core(const Posed<MeshShape>& posed) {
    if (posed.what->form() == MeshForm::convex) return {static_cast<const ConvexSolid&>(*posed.what), posed.pose};
    return {std::make_shared<const ConvexSolid>(posed.what->mesh_ptr()), posed.pose};
}

}  // namespace ecods::convex
