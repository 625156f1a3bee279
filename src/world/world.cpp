#include <utility>

#include "base/misuse.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/same_bits.hpp"
#include "narrow_phase/mesh_mesh_test.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

void require_valid(const Pose& pose, BodyId body) {
    if (const auto bad = find_invalid(pose)) throw InvalidPose(bad->row, bad->column, bad->value, body);
}

// The shape's box, checked: what enters the broad phase must be ordered.
Aabb box_for(const Shape& shape, const Pose& pose) {
    const Aabb box = shape.box(pose);
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.min[axis] <= box.max[axis])) throw InvalidBox(shape.kind(), axis, box.min[axis], box.max[axis]);
    }
    return box;
}

void require_usable(const std::shared_ptr<const Shape>& shape) {
    if (!shape) throw NullArgument("shape");
    if (shape->kind() == ShapeKind::mesh() && dynamic_cast<const MeshShape*>(shape.get()) == nullptr) {
        throw NotSupported("shape kind 0 is taken by MeshShape; a shape of one's own needs another kind");
    }
}

}  // namespace

World::Impl::Impl(const WorldOptions& options) : broad_phase(make_broad_phase(options.broad_phase)) {
    tests.set(ShapeKind::mesh(), ShapeKind::mesh(), make_mesh_mesh_test());
}

World::World(const WorldOptions& options) : impl_(std::make_unique<Impl>(options)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

ProxyIndex World::Impl::require(BodyId body) const {
    const bool is_known = body && body.slot <= slots.size() && slots[body.slot - 1].is_alive() &&
                          slots[body.slot - 1].generation == body.generation;
    if (!is_known) throw_misuse(StaleBody(body));
    return body.slot - 1;
}

// One MeshShape, and so one tree, for all bodies of a mesh while any of them lives.
std::shared_ptr<const Shape> World::Impl::shape_of(const std::shared_ptr<const Mesh>& mesh) {
    if (!mesh) throw NullArgument("mesh");
    if (mesh_shapes.size() >= mesh_shapes_max) {
        std::erase_if(mesh_shapes, [](const auto& entry) { return entry.second.expired(); });
        mesh_shapes_max = 2 * mesh_shapes.size() + 16;
    }
    std::weak_ptr<const MeshShape>& known = mesh_shapes[mesh.get()];
    if (auto shape = known.lock()) return shape;
    auto shape = std::make_shared<const MeshShape>(mesh);
    known = shape;
    return shape;
}

// A body of `kind` comes into the world, in place of `replaced` if that is not null.
void World::Impl::require_tests_for(ShapeKind kind, const Shape* replaced) const {
    for (const auto& [other, count] : kind_counts) {
        const std::size_t remaining = count - (replaced != nullptr && replaced->kind() == other);
        if (remaining != 0 && !tests.has(kind, other)) throw MissingTest(kind, other);
    }
}

void World::Impl::mark_changed(ProxyIndex proxy) {
    if (slots[proxy].is_changed) return;
    changed.push_back(proxy);
    slots[proxy].is_changed = true;
}

BodyId World::create_body(std::shared_ptr<const Mesh> mesh, const Pose& pose) {
    return create_body(impl_->shape_of(mesh), pose);
}

BodyId World::create_body(std::shared_ptr<const Shape> shape, const Pose& pose) {
    Impl& w = *impl_;
    require_usable(shape);
    require_valid(pose, {});
    w.require_tests_for(shape->kind(), nullptr);
    const Aabb box = box_for(*shape, pose);

    if (w.free_slots.empty()) {
        w.slots.emplace_back();
        w.free_slots.push_back(static_cast<ProxyIndex>(w.slots.size() - 1));
    }
    const ProxyIndex proxy = w.free_slots.back();
    w.changed.reserve(w.changed.size() + 1);
    std::size_t& kind_count = w.kind_counts[shape->kind()];
    w.broad_phase->add(proxy, box);
    // Nothing below throws.
    w.free_slots.pop_back();
    ++kind_count;
    Slot& slot = w.slots[proxy];
    slot.shape = std::move(shape);
    slot.pose = pose;
    slot.box = box;
    w.mark_changed(proxy);
    return w.id_of(proxy);
}

void World::destroy_body(BodyId body) {
    Impl& w = *impl_;
    const ProxyIndex proxy = w.require(body);
    w.free_slots.reserve(w.free_slots.size() + 1);
    w.broad_phase->remove(proxy);
    Slot& slot = w.slots[proxy];
    --w.kind_counts[slot.shape->kind()];
    slot.shape.reset();
    ++slot.generation;
    w.free_slots.push_back(proxy);
    w.candidates_are_dirty = true;
}

void World::set_pose(BodyId body, const Pose& pose) {
    Impl& w = *impl_;
    const ProxyIndex proxy = w.require(body);
    require_valid(pose, body);
    Slot& slot = w.slots[proxy];
    if (same_bits(slot.pose, pose)) return;
    const Aabb box = box_for(*slot.shape, pose);
    w.changed.reserve(w.changed.size() + 1);
    w.broad_phase->move(proxy, box);
    slot.pose = pose;
    slot.box = box;
    w.mark_changed(proxy);
}

void World::set_shape(BodyId body, std::shared_ptr<const Mesh> mesh) {
    impl_->require(body);
    set_shape(body, impl_->shape_of(mesh));
}

void World::set_shape(BodyId body, std::shared_ptr<const Shape> shape) {
    Impl& w = *impl_;
    const ProxyIndex proxy = w.require(body);
    require_usable(shape);
    Slot& slot = w.slots[proxy];
    if (slot.shape == shape) return;
    w.require_tests_for(shape->kind(), slot.shape.get());
    const Aabb box = box_for(*shape, slot.pose);
    w.changed.reserve(w.changed.size() + 1);
    std::size_t& kind_count = w.kind_counts[shape->kind()];
    w.broad_phase->move(proxy, box);
    --w.kind_counts[slot.shape->kind()];
    ++kind_count;
    slot.shape = std::move(shape);
    slot.box = box;
    w.mark_changed(proxy);
}

bool World::is_alive(BodyId body) const noexcept {
    const auto& slots = impl_->slots;
    return body && body.slot <= slots.size() && slots[body.slot - 1].is_alive() &&
           slots[body.slot - 1].generation == body.generation;
}

const Pose& World::pose(BodyId body) const {
    return impl_->slots[impl_->require(body)].pose;
}

const std::shared_ptr<const Shape>& World::shape(BodyId body) const {
    return impl_->slots[impl_->require(body)].shape;
}

const Aabb& World::box(BodyId body) const {
    return impl_->slots[impl_->require(body)].box;
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> result;
    for (ProxyIndex proxy = 0; proxy < impl_->slots.size(); ++proxy) {
        if (impl_->slots[proxy].is_alive()) result.push_back(impl_->id_of(proxy));
    }
    return result;
}

void World::set_test(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test) {
    Impl& w = *impl_;
    if (!test) throw NullArgument("test");
    w.changed.reserve(w.slots.size());
    w.tests.set(a, b, std::move(test));
    for (ProxyIndex proxy = 0; proxy < w.slots.size(); ++proxy) {
        const Slot& slot = w.slots[proxy];
        if (slot.is_alive() && (slot.shape->kind() == a || slot.shape->kind() == b)) w.mark_changed(proxy);
    }
}

}  // namespace ecods
