#include "world/world_impl.hpp"

namespace ecods {

std::vector<BodyId> World::overlapping_bodies(const Aabb& box) const {
    std::vector<BodyId> result;
    for (const ProxyIndex proxy : impl_->broad_phase->find(box)) result.push_back(impl_->id_of(proxy));
    return result;
}

std::vector<BodyId> World::intersecting_bodies(const std::shared_ptr<const Mesh>& mesh, const Pose& pose,
                                               const CollisionFilter* filter) {
    return intersecting_bodies(*impl_->shape_of(mesh), pose, filter);
}

std::vector<BodyId> World::intersecting_bodies(const Shape& shape, const Pose& pose, const CollisionFilter* filter) {
    Impl& w = *impl_;
    require_mesh_kind(shape);
    require_valid(pose);
    w.require_tests_for(shape.kind(), nullptr);
    const PosedShape asked{shape, pose};
    std::vector<BodyId> result;
    for (const ProxyIndex proxy : w.broad_phase->find(box_for(shape, pose))) {
        const Slot& slot = w.slots[proxy];
        if (filter != nullptr && !may_meet(*filter, slot.filter)) continue;
        const bool is_touching =
            w.tests.find(shape.kind(), slot.kind)
                .ask(asked, slot.posed(), [&](const TwoBodyTest& t, const PosedShape& a, const PosedShape& b) {
                    return t.intersects(a, b, w.memories[0]);
                });
        if (is_touching) result.push_back(w.id_of(proxy));
    }
    return result;
}

}  // namespace ecods
