#include <algorithm>
#include <atomic>
#include <limits>
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
    Aabb box = shape.box(pose);
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

namespace {

// Numbers the worlds of this process from 1, and from 1 again after the largest number that an id can hold.
std::uint16_t next_world_number() noexcept {
    static std::atomic<std::uint32_t> count = 0;
    constexpr std::uint32_t number_max = std::numeric_limits<std::uint16_t>::max();
    return static_cast<std::uint16_t>(count.fetch_add(1, std::memory_order_relaxed) % number_max + 1);
}

}  // namespace

World::Impl::Impl(const WorldOptions& options)
    : number(next_world_number()), broad_phase(make_broad_phase(options.broad_phase)), executor(options.executor) {
    tests.set(ShapeKind::mesh(), ShapeKind::mesh(), make_mesh_mesh_test());
    memories.resize(executor ? std::max<std::size_t>(1, executor->worker_count()) : 1);
}

World::World(const WorldOptions& options) : impl_(std::make_unique<Impl>(options)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

bool World::Impl::is_alive(BodyId body) const noexcept {
    return body && body.slot <= slots.size() && slots[body.slot - 1].is_alive() &&
           slots[body.slot - 1].generation == body.generation && (body.world == number || body.world == 0);
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
    if (auto shape = known_shape_of(mesh)) return shape;
    auto shape = std::make_shared<const MeshShape>(mesh);
    mesh_shapes[mesh.get()] = shape;
    return shape;
}

std::shared_ptr<const MeshShape> World::Impl::known_shape_of(const std::shared_ptr<const Mesh>& mesh) const {
    const auto known = mesh_shapes.find(mesh.get());
    return known == mesh_shapes.end() ? nullptr : known->second.lock();
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

World::Impl& World::impl() {
    if (!impl_) throw_misuse(MovedFromWorld());
    return *impl_;
}

const World::Impl& World::impl() const {
    if (!impl_) throw_misuse(MovedFromWorld());
    return *impl_;
}

bool World::is_alive(BodyId body) const noexcept {
    return impl_ && impl_->is_alive(body);
}

Pose World::pose(BodyId body) const {
    const Impl& w = impl();
    return w.slots[w.require(body)].pose;
}

std::shared_ptr<const Shape> World::shape(BodyId body) const {
    const Impl& w = impl();
    return w.slots[w.require(body)].shape;
}

Aabb World::box(BodyId body) const {
    const Impl& w = impl();
    return w.boxes[w.require(body)];
}

std::uint64_t World::user_data(BodyId body) const {
    const Impl& w = impl();
    return w.slots[w.require(body)].user_data;
}

void World::set_user_data(BodyId body, std::uint64_t data) {
    Impl& w = impl();
    w.slots[w.require(body)].user_data = data;
    if (w.trace) w.trace->write<calls::SetUserData>(body, data);
}

std::vector<BodyId> World::bodies() const {
    const Impl& w = impl();
    std::vector<BodyId> result;
    for (ProxyIndex proxy = 0; proxy < w.slots.size(); ++proxy) {
        if (w.slots[proxy].is_alive()) result.push_back(w.id_of(proxy));
    }
    return result;
}

}  // namespace ecods
