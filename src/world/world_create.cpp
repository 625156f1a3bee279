#include <utility>

#include "world/world_impl.hpp"

namespace ecods {

BodyId World::create_body(std::shared_ptr<const Mesh> mesh, const Pose& pose) {
    return create_body({.mesh = std::move(mesh), .pose = pose});
}

BodyId World::create_body(std::shared_ptr<const Shape> shape, const Pose& pose) {
    return create_body({.shape = std::move(shape), .pose = pose});
}

BodyId World::create_body(const BodyOptions& options) {
    Impl& w = impl();
    if (options.mesh && options.shape) throw MeshAndShape();
    std::shared_ptr<const Shape> shape = options.mesh ? w.shape_of(options.mesh) : options.shape;
    require_usable(shape);
    require_valid(options.pose);
    w.require_tests_for(shape->kind(), nullptr);
    const Aabb box = box_for(*shape, options.pose);
    const std::uint64_t number = w.traced_number(shape);

    if (w.free_slots.empty()) {
        make_room(w.free_slots);
        w.boxes.resize(w.slots.size() + 1);
        w.changes.resize(w.slots.size() + 1);
        w.slots.emplace_back();
        w.free_slots.push_back(static_cast<ProxyIndex>(w.slots.size() - 1));
    }
    const ProxyIndex proxy = w.free_slots.back();
    make_room(w.changed);
    std::size_t& kind_count = w.kind_counts[shape->kind()];
    w.broad_phase->add(proxy, box);
    // Nothing below throws.
    w.free_slots.pop_back();
    ++kind_count;
    Slot& slot = w.slots[proxy];
    w.put_shape(slot, std::move(shape));
    slot.pose = options.pose;
    slot.filter = options.filter;
    slot.user_data = options.user_data;
    w.boxes[proxy] = box;
    w.mark_changed(proxy, Change::body);
    if (w.trace) w.trace_body(proxy, number);
    return w.id_of(proxy);
}

void World::destroy_body(BodyId body) {
    Impl& w = impl();
    const ProxyIndex proxy = w.require(body);
    make_room(w.free_slots);
    w.broad_phase->remove(proxy);
    // Nothing below throws.
    Slot& slot = w.slots[proxy];
    --w.kind_counts[slot.kind];
    slot.shape.reset();
    if (slot.generation != Slot::generation_max) {
        ++slot.generation;
        w.free_slots.push_back(proxy);
    } else {
        ++w.retired_count;
    }
    w.disabled.forget(proxy);
    w.candidates_are_dirty = true;
    if (w.trace) w.trace->write<calls::Destroy>(body);
}

void World::reserve(std::size_t body_count) {
    Impl& w = impl();
    w.slots.reserve(body_count);
    w.boxes.reserve(body_count);
    w.changes.reserve(body_count);
    w.free_slots.reserve(body_count);
    w.changed.reserve(body_count);
    w.verdicts.reserve(0, body_count);
    w.broad_phase->reserve(body_count);
}

}  // namespace ecods
