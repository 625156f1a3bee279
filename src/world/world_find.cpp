#include "world/world_impl.hpp"

namespace ecods {

std::vector<BodyId> World::overlapping_bodies(const Aabb& box) const {
    const Impl& w = impl();
    std::vector<BodyId> result;
    for (const ProxyIndex proxy : w.broad_phase.find(box)) result.push_back(w.bodies.id_of(proxy));
    return result;
}

std::vector<BodyId> World::intersecting_bodies(const Shape& shape, const Pose& pose, QueryMemory& memory,
                                               std::optional<CollisionFilter> filter) const {
    const Impl& w = impl();
    require_mesh_kind(shape);
    require_valid(pose);
    w.require_tests_for(shape.kind(), nullptr);
    const Posed<Shape> asked(shape, pose);
    std::vector<BodyId> result;
    for (const ProxyIndex proxy : w.broad_phase.find(box_for(shape, pose))) {
        const Slot& slot = w.bodies[proxy];
        if (filter && !may_meet(*filter, slot.filter)) continue;
        const bool is_intersecting =
            w.tests.find(shape.kind(), slot.kind).ask(asked, slot.posed(), &TwoBodyTest::intersects, memory);
        if (is_intersecting) result.push_back(w.bodies.id_of(proxy));
    }
    return result;
}

std::vector<BodyId> World::intersecting_bodies(const std::shared_ptr<const Mesh>& mesh, const Pose& pose,
                                               QueryMemory& memory, std::optional<CollisionFilter> filter) const {
    return impl().mesh_shapes.with(
        mesh, [&](const MeshShape& shape) { return intersecting_bodies(shape, pose, memory, filter); });
}

std::vector<BodyId> World::intersecting_bodies(const Shape& shape, const Pose& pose,
                                               std::optional<CollisionFilter> filter) {
    return intersecting_bodies(shape, pose, impl().workers.caller_memory(), filter);
}

std::vector<BodyId> World::intersecting_bodies(const std::shared_ptr<const Mesh>& mesh, const Pose& pose,
                                               std::optional<CollisionFilter> filter) {
    return intersecting_bodies(mesh, pose, impl().workers.caller_memory(), filter);
}

}  // namespace ecods
