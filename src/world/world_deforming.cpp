// Answers which body of a world a deforming mesh meets first.
#include "ecods/cast.hpp"

#include "query/intersection/asking.hpp"
#include "world/first_met.hpp"

namespace ecods {

// Tests the bodies whose boxes overlap the box of the whole motion, ascending by id.
std::optional<BodyContact> World::cast(const Deforming& mesh, double max_time, std::optional<CollisionFilter> filter,
                                       const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject{Posed<Shape>(*mesh.shape(), Pose()), std::nullopt, filter};
    FirstBodyMet first(require_time(max_time));
    if (!w.bodies.are_meshes()) {
        w.for_each_asked(subject, [](const Slot& slot) {
            if (slot.kind != ShapeKind::mesh()) {
                throw NotSupported(Question::cast_moving, ShapeKind::mesh(), slot.kind);
            }
        });
    }
    Asking asking(ask);
    for (const ProxyIndex proxy : w.broad_phase.find(mesh.box())) {
        if (w.passes_over(subject, proxy)) continue;
        const Slot& slot = w.bodies[proxy];
        const Posed<MeshShape> other(static_cast<const MeshShape&>(*slot.shape), slot.pose);
        first.take(proxy, [&](double limit) { return ecods::cast(mesh, other, limit, asking.memory()); });
    }
    return first.answer(w.bodies);
}

}  // namespace ecods
