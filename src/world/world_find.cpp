#include "geometry/key_box.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Calls `act` for the living bodies whose boxes overlap this one, ascending. The boxes lie side by side.
template <class Act>
void for_overlapping(const std::vector<Slot>& slots, const std::vector<Aabb>& boxes, const Aabb& box, Act act) {
    const KeyBox keys = key_box(box);
    for (ProxyIndex proxy = 0; proxy < slots.size(); ++proxy) {
        if (overlap(keys, key_box(boxes[proxy])) && slots[proxy].is_alive()) act(proxy);
    }
}

}  // namespace

std::vector<BodyId> World::overlapping_bodies(const Aabb& box) const {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.min[axis] <= box.max[axis])) throw InvalidBox(axis, box.min[axis], box.max[axis]);
    }
    std::vector<BodyId> result;
    for_overlapping(impl_->slots, impl_->boxes, box, [&](ProxyIndex proxy) { result.push_back(impl_->id_of(proxy)); });
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
    for_overlapping(w.slots, w.boxes, box_for(shape, pose), [&](ProxyIndex proxy) {
        const Slot& slot = w.slots[proxy];
        if (filter != nullptr && !may_meet(*filter, slot.filter)) return;
        const bool is_touching =
            w.tests.find(shape.kind(), slot.kind)
                .ask(asked, slot.posed(), [&](const TwoBodyTest& t, const PosedShape& a, const PosedShape& b) {
                    return t.intersects(a, b, w.memories[0]);
                });
        if (is_touching) result.push_back(w.id_of(proxy));
    });
    return result;
}

}  // namespace ecods
