#include "ecods/solid.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/solid/surface_search.hpp"
#include "query/solid/surfaces_meet.hpp"

namespace ecods {

SurfaceRelation surface_relation(const Posed<MeshShape>& surface, const Posed<Solid>& solid, QueryMemory& memory) {
    auto& state = QueryMemoryAccess::state(memory);
    ++state.counts.queries;
    const SurfaceAt of(surface), boundary(solid);
    if (!exact::is_regular(solid.pose.R)) {
        // The solid is the image of its surface, and has no inner point.
        return surfaces_meet(of, boundary, memory) ? SurfaceRelation::touching : SurfaceRelation::apart;
    }
    const Pose &at = surface.pose, &solid_at = solid.pose;
    const int axis = state.axes.bind({of.tree.boxes, at.R}, {boundary.tree.boxes, solid_at.R}, solid_at.t - at.t);
    if (axis >= 0) return SurfaceRelation::apart;
    return SurfaceSearch(of, *solid.what, boundary, memory).find();
}

}  // namespace ecods
