#include <algorithm>
#include <utility>

#include "base/misuse.hpp"
#include "geometry/find_invalid.hpp"
#include "query/intersection/mesh_mesh_test.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void require_valid(const Pose& pose, BodyId body, const ListIndex& index) {
    if (const auto bad = find_invalid(pose)) throw InvalidPose(bad->row, bad->column, bad->value, body, index);
}

Aabb box_for(const Shape& shape, const Pose& pose, BodyId body, const ListIndex& index) {
    const Aabb box = shape.box(pose);
    for (int axis = 0; axis < 3; ++axis) {
        if (box.min[axis] <= box.max[axis]) continue;
        throw InvalidBox(shape.kind(), axis, box.min[axis], box.max[axis], body, index);
    }
    return box;
}

void require_usable(const std::shared_ptr<const Shape>& shape) {
    if (!shape) throw NullArgument("shape");
    require_mesh_kind(*shape);
}

void require_mesh_kind(const Shape& shape) {
    if (shape.kind() == ShapeKind::mesh() && dynamic_cast<const MeshShape*>(&shape) == nullptr) {
        throw NotSupported("shape kind 0 is taken by MeshShape; a shape of one's own needs another kind");
    }
}

World::Impl::Impl(const WorldOptions& options)
    : broad_phase(make_broad_phase(options.broad_phase)), executor(options.executor) {
    tests.set(ShapeKind::mesh(), ShapeKind::mesh(), make_mesh_mesh_test());
    memories.resize(executor ? std::max<std::size_t>(1, executor->worker_count()) : 1);
}

World::World(const WorldOptions& options) : impl_(std::make_unique<Impl>(options)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

bool World::Impl::is_alive(BodyId body) const noexcept {
    return body && body.slot <= slots.size() && slots[body.slot - 1].is_alive() &&
           slots[body.slot - 1].generation == body.generation;
}

ProxyIndex World::Impl::require(BodyId body, const ListIndex& index) const {
    if (!is_alive(body)) throw_misuse(StaleBody(body, index));
    return body.slot - 1;
}

// The smaller slot first, so that either order of arguments asks the very same question.
ProxyPair World::Impl::require_pair(BodyId a, BodyId b) const {
    const ProxyIndex first = require(a);
    const ProxyIndex second = require(b);
    if (first == second) throw_misuse(SameBody(a));
    return {std::min(first, second), std::max(first, second)};
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

void World::Impl::put_shape(Slot& slot, std::shared_ptr<const Shape> shape) noexcept {
    slot.kind = shape->kind();
    slot.shape_digest = shape->digest();
    slot.shape = std::move(shape);
}

void World::Impl::mark_changed(ProxyIndex proxy, Change change) noexcept {
    Change& known = changes[proxy];
    if (known == Change::none) changed.push_back(proxy);
    known = std::max(known, change);
}

bool World::is_alive(BodyId body) const noexcept {
    return impl_->is_alive(body);
}

Pose World::pose(BodyId body) const {
    return impl_->slots[impl_->require(body)].pose;
}

std::shared_ptr<const Shape> World::shape(BodyId body) const {
    return impl_->slots[impl_->require(body)].shape;
}

Aabb World::box(BodyId body) const {
    return impl_->boxes[impl_->require(body)];
}

std::uint64_t World::user_data(BodyId body) const {
    return impl_->slots[impl_->require(body)].user_data;
}

void World::set_user_data(BodyId body, std::uint64_t data) {
    impl_->slots[impl_->require(body)].user_data = data;
    if (impl_->trace) impl_->trace->write<calls::SetUserData>(body, data);
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> result;
    for (ProxyIndex proxy = 0; proxy < impl_->slots.size(); ++proxy) {
        if (impl_->slots[proxy].is_alive()) result.push_back(impl_->id_of(proxy));
    }
    return result;
}

}  // namespace ecods
