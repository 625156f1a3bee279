#include <utility>

#include "base/make_error.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void World::set_shape(BodyId body, const std::shared_ptr<const Mesh>& mesh) {
    impl().bodies.require(body);
    set_shape(body, impl().mesh_shapes.shape_of(mesh));
}

void World::set_shape(BodyId body, std::shared_ptr<const Shape> shape) {
    Impl& w = impl();
    const ProxyIndex proxy = w.bodies.require(body);
    require_usable(shape);
    const Slot& slot = w.bodies[proxy];
    if (slot.shape == shape) return;
    w.require_update_tests_for(shape->kind(), slot.shape.get());
    const Aabb box = box_for(*shape, slot.pose, body);
    const std::uint64_t number = w.traced_number(shape);
    w.changes.make_room_for(1);
    w.bodies.make_room_for(shape->kind());
    w.broad_phase.move(proxy, box);
    // Nothing below throws.
    w.bodies.set_shape(proxy, std::move(shape));
    w.changes.mark(proxy, Change::body);
    if (w.trace) w.trace->write<calls::SetShape>(body, number);
}

void World::set_test(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test) {
    Impl& w = impl();
    if (!test) throw null_argument("test");
    if (w.bodies.has_pair_of(a, b)) {
        for (const auto question : w.update_questions()) {
            if (question) require_answer(*test, *question, a, b);
        }
    }
    w.changes.make_room_for_all();
    w.tests.set(a, b, std::move(test));
    for (ProxyIndex proxy = 0; proxy < w.bodies.end(); ++proxy) {
        const Slot& slot = w.bodies[proxy];
        if (slot.is_alive() && (slot.kind == a || slot.kind == b)) w.changes.mark(proxy, Change::test);
    }
    if (w.trace) w.trace->note("the test of two kinds of shape was set");
}

}  // namespace ecods
