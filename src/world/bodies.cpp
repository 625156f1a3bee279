#include "world/bodies.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "base/misuse.hpp"

namespace ecods {
namespace {

// Numbers the worlds of this process from 1, and from 1 again after the largest number that an id can hold.
std::uint16_t next_world_number() noexcept {
    static std::atomic<std::uint32_t> count = 0;
    constexpr std::uint32_t number_max = std::numeric_limits<std::uint16_t>::max();
    return static_cast<std::uint16_t>(count.fetch_add(1, std::memory_order_relaxed) % number_max + 1);
}

}  // namespace

void Slot::put(std::shared_ptr<const Shape> new_shape) noexcept {
    kind = new_shape->kind();
    shape_digest = new_shape->digest();
    shape = std::move(new_shape);
}

Bodies::Bodies() : world_number_(next_world_number()) {}

// ---- ids

bool Bodies::is_alive(BodyId body) const noexcept {
    return body && body.slot <= slots_.size() && slots_[body.slot - 1].is_alive() &&
           slots_[body.slot - 1].generation == body.generation && (body.world == world_number_ || body.world == 0);
}

ProxyIndex Bodies::require(BodyId body, const ListIndex& index) const {
    if (!is_alive(body)) throw_misuse(StaleBody(body, index));
    return body.slot - 1;
}

// The smaller slot first, so that either order of arguments asks the very same question.
ProxyPair Bodies::require_pair(BodyId a, BodyId b) const {
    const ProxyIndex first = require(a);
    const ProxyIndex second = require(b);
    if (first == second) throw_misuse(SameBody(a));
    return {std::min(first, second), std::max(first, second)};
}

std::vector<BodyId> Bodies::ids() const {
    std::vector<BodyId> result;
    for (ProxyIndex proxy = 0; proxy < end(); ++proxy) {
        if (slots_[proxy].is_alive()) result.push_back(id_of(proxy));
    }
    return result;
}

// ---- coming, changing and going

void Bodies::reserve(std::size_t count) {
    slots_.reserve(count);
    boxes_.reserve(count);
    free_slots_.reserve(count);
}

ProxyIndex Bodies::make_slot(ShapeKind kind) {
    if (free_slots_.empty()) {
        make_room(free_slots_);
        boxes_.resize(slots_.size() + 1);
        slots_.emplace_back();
        free_slots_.push_back(end() - 1);
    }
    make_room_for(kind);
    return free_slots_.back();
}

void Bodies::create(const BodyOptions& options, std::shared_ptr<const Shape> shape, const Aabb& box) noexcept {
    const ProxyIndex proxy = free_slots_.back();
    free_slots_.pop_back();
    Slot& slot = slots_[proxy];
    slot.put(std::move(shape));
    ++kind_counts_[slot.kind];
    slot.pose = options.pose;
    slot.filter = options.filter;
    slot.user_data = options.user_data;
    boxes_[proxy] = box;
}

void Bodies::set_shape(ProxyIndex proxy, std::shared_ptr<const Shape> shape, const Aabb& box) noexcept {
    Slot& slot = slots_[proxy];
    --kind_counts_[slot.kind];
    slot.put(std::move(shape));
    ++kind_counts_[slot.kind];
    boxes_[proxy] = box;
}

void Bodies::set_pose(ProxyIndex proxy, const Pose& pose, const Aabb& box) noexcept {
    slots_[proxy].pose = pose;
    boxes_[proxy] = box;
}

void Bodies::make_room_to_destroy() {
    make_room(free_slots_);
}

void Bodies::destroy(ProxyIndex proxy) noexcept {
    Slot& slot = slots_[proxy];
    --kind_counts_[slot.kind];
    slot.shape.reset();
    if (slot.generation != Slot::generation_max) {
        ++slot.generation;
        free_slots_.push_back(proxy);
    } else {
        ++retired_count_;
    }
    disabled_.forget(proxy);
}

// ---- inspection

std::size_t Bodies::memory_bytes() const noexcept {
    return bytes_of(slots_, boxes_, free_slots_) + disabled_.memory_bytes();
}

namespace {

// A mesh cannot change, and its box depends on the rounding mode; what a caller's shape says is asked again.
void require_unchanged(const Slot& slot, const Aabb& box, BodyId body) {
    if (slot.kind == ShapeKind::mesh()) return;
    if (slot.shape->kind() != slot.kind) throw ShapeChanged(body, slot.kind, "kind");
    if (slot.shape->digest() != slot.shape_digest) throw ShapeChanged(body, slot.kind, "digest");
    if (!(slot.shape->box(slot.pose) == box)) throw ShapeChanged(body, slot.kind, "box");
}

}  // namespace

void Bodies::validate() const {
    std::size_t count = 0;
    for (ProxyIndex proxy = 0; proxy < end(); ++proxy) {
        if (!slots_[proxy].is_alive()) continue;
        ++count;
        require_unchanged(slots_[proxy], boxes_[proxy], id_of(proxy));
    }
    if (count != alive_count()) throw BrokenInvariant("a slot is neither free nor used");
}

}  // namespace ecods
