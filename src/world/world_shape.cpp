#include <utility>

#include "world/world_impl.hpp"

namespace ecods {

void World::set_shape(BodyId body, const std::shared_ptr<const Mesh>& mesh) {
    impl().require(body);
    set_shape(body, impl().shape_of(mesh));
}

void World::set_shape(BodyId body, std::shared_ptr<const Shape> shape) {
    Impl& w = impl();
    const ProxyIndex proxy = w.require(body);
    require_usable(shape);
    Slot& slot = w.slots[proxy];
    if (slot.shape == shape) return;
    w.require_tests_for(shape->kind(), slot.shape.get());
    const Aabb box = box_for(*shape, slot.pose, body);
    const std::uint64_t number = w.traced_number(shape);
    make_room(w.changed);
    std::size_t& kind_count = w.kind_counts[shape->kind()];
    w.broad_phase->move(proxy, box);
    // Nothing below throws.
    --w.kind_counts[slot.kind];
    ++kind_count;
    w.put_shape(slot, std::move(shape));
    w.boxes[proxy] = box;
    w.mark_changed(proxy, Change::body);
    if (w.trace) w.trace->write<calls::SetShape>(body, number);
}

void World::set_test(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test) {
    Impl& w = impl();
    if (!test) throw NullArgument("test");
    w.changed.reserve(w.slots.size());
    w.tests.set(a, b, std::move(test));
    for (ProxyIndex proxy = 0; proxy < w.slots.size(); ++proxy) {
        const Slot& slot = w.slots[proxy];
        if (slot.is_alive() && (slot.kind == a || slot.kind == b)) w.mark_changed(proxy, Change::test);
    }
    if (w.trace) w.trace->note("the test of two kinds of shape was set");
}

}  // namespace ecods
