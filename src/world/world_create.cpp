#include <utility>

#include "base/make_error.hpp"
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
    if (options.mesh && options.shape) throw mesh_and_shape();
    std::shared_ptr<const Shape> shape = options.mesh ? w.mesh_shapes.shape_of(options.mesh) : options.shape;
    require_usable(shape);
    require_valid(options.pose);
    w.require_update_tests_for(shape->kind(), nullptr);
    const Aabb box = box_for(*shape, options.pose);
    const std::uint64_t number = w.traced_number(shape);

    const ProxyIndex proxy = w.bodies.make_slot(shape->kind());
    w.changes.add_slots_below(w.bodies.end());
    w.changes.make_room_for(1);
    w.broad_phase.add(proxy, box);
    // Nothing below throws.
    w.bodies.create(options, std::move(shape));
    w.changes.mark(proxy, Change::body);
    if (w.trace) w.trace_body(proxy, number);
    return w.bodies.id_of(proxy);
}

void World::destroy_body(BodyId body) {
    Impl& w = impl();
    const ProxyIndex proxy = w.bodies.require(body);
    w.bodies.make_room_to_destroy();
    w.changes.make_room_for(1);
    w.broad_phase.remove(proxy);
    // Nothing below throws.
    w.bodies.destroy(proxy);
    w.changes.mark(proxy, Change::body);
    if (w.trace) w.trace->write<calls::Destroy>(body);
}

void World::reserve(std::size_t body_count) {
    Impl& w = impl();
    w.bodies.reserve(body_count);
    w.changes.reserve(body_count);
    w.collisions.reserve_bodies(body_count);
    w.broad_phase.reserve(body_count);
}

}  // namespace ecods
