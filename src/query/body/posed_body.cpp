#include "query/body/posed_body.hpp"

#include "exact/simplex/common_pose.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {

NamedBoundary boundary_of(const MeshShape& shape) {
    if (shape.form() == MeshForm::surface) return {shape, {}};
    const SolidBoundary& proper = SolidAccess::boundary(static_cast<const Solid&>(shape));
    return proper.shape != nullptr ? NamedBoundary{*proper.shape, proper.names} : NamedBoundary{shape, {}};
}

PosedBody::PosedBody(const Posed<MeshShape>& posed, Meaning meaning) : boundary_(*posed.what, posed.pose) {
    if (posed.what->form() == MeshForm::surface || meaning == Meaning::surface) return;
    const NamedBoundary boundary = boundary_of(*posed.what);
    boundary_.what = &boundary.shape;
    names_ = boundary.names;
    if (!exact::is_regular(posed.pose.R)) return;
    if (ecods::has_inside(*posed.what)) solid_ = static_cast<const Solid*>(posed.what);
    if (posed.what->form() == MeshForm::convex) convex_ = static_cast<const ConvexSolid*>(posed.what);
}

}  // namespace ecods
