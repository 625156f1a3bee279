#include <memory>
#include <utility>

#include "base/make_error.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "query/convex/convex_parts.hpp"
#include "query/convex/convexity.hpp"
#include "query/convex/hull_build.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace {

using namespace convex;

Hull make_hull(const Solid& solid) {
    const SolidAccess::Parts& parts = SolidAccess::parts(solid);
    if (parts.flat) return build_flat_hull(parts.proper, *parts.flat);
    const Shells& shells = SolidAccess::shells(solid);
    const Mesh& mesh = solid.mesh();
    // Features are named in the mesh as given. If edges were split, `whole` is the mesh before the split.
    ProperMesh whole;
    if (!parts.origins.empty()) whole = find_proper({std::shared_ptr<const void>(), &mesh});  // the solid owns the mesh
    const Border border{&parts.proper,   &parts.edges,
                        shells.faces_in, parts.origins.empty() ? &parts.proper : &whole,
                        parts.origins,   exact::VertexSigns(parts.proper.mesh->vertices())};
    return build_hull(border, require_convex(border, shells, mesh));
}

}  // namespace

ConvexSolid::ConvexSolid(std::shared_ptr<const Mesh> mesh)
    : Solid(std::move(mesh), MeshForm::convex), convex_parts_(std::make_unique<ConvexParts>()) {
    convex_parts_->hull = make_hull(*this);
    convex_parts_->points = make_support_points(this->mesh(), convex_parts_->hull);
}

ConvexSolid::ConvexSolid(std::span<const Vec3> points) : ConvexSolid(convex_hull(points)) {}

ConvexSolid::~ConvexSolid() = default;

int ConvexSolid::dimension() const noexcept {
    const Hull& hull = convex_parts_->hull;
    if (!hull.is_flat()) return 3;
    return hull.faces.empty() ? static_cast<int>(hull.edges.size()) : 2;
}

}  // namespace ecods
