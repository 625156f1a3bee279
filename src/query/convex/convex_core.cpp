#include "query/convex/convex_core.hpp"

#include <memory>

#include "query/shape/mesh_tree.hpp"

namespace ecods::convex {
namespace {

std::unique_ptr<const ConvexSolid> make_core(const MeshShape& shape) {
    return std::make_unique<const ConvexSolid>(shape.mesh_ptr());
}

}  // namespace

bool is_convex_core(const MeshShape& shape) noexcept {
    return shape.form() == MeshForm::convex || shape.mesh().triangles().size() == 1;
}

Posed<ConvexSolid> convex_core(const Posed<MeshShape>& posed) {
    if (posed.what->form() == MeshForm::convex) return {static_cast<const ConvexSolid&>(*posed.what), posed.pose};
    return {MeshShapeAccess::convex(*posed.what, make_core), posed.pose};
}

}  // namespace ecods::convex
