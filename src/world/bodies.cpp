#include "world/bodies.hpp"

#include <algorithm>
#include <atomic>
#include <ranges>
#include <string>
#include <utility>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "base/misuse.hpp"

namespace ecods {
namespace {

// Returns the number of a new world. The numbers are 1, 2, and so on; after the largest number that an id can hold,
// they begin at 1 again.
std::uint16_t next_world_number() noexcept {
    static std::atomic<std::uint32_t> count = 0;
    constexpr std::uint32_t number_max = std::numeric_limits<std::uint16_t>::max();
    return static_cast<std::uint16_t>(count.fetch_add(1, std::memory_order_relaxed) % number_max + 1);
}

std::uint16_t world_number_of(std::span<const BodyId> first_ids) noexcept {
    return first_ids.empty() || first_ids.front().world == 0 ? next_world_number() : first_ids.front().world;
}

}  // namespace

void Slot::put(std::shared_ptr<const Shape> new_shape) noexcept {
    kind = new_shape->kind();
    shape_digest = new_shape->digest();
    answers_hits = new_shape->answers(Question::hits);
    const auto* const of_mesh = dynamic_cast<const MeshShape*>(new_shape.get());
    form = of_mesh != nullptr ? of_mesh->form() : MeshForm::surface;
    shape = std::move(new_shape);
}

// Retires each slot that no id names: such a slot has used up its generations. The free slots form a stack, so the
// first id is pushed last.
Bodies::Bodies(std::span<const BodyId> first_ids) : world_number_(world_number_of(first_ids)) {
    std::size_t slot_count = 0;
    for (const BodyId id : first_ids) slot_count = std::max(slot_count, std::size_t{id.slot});
    slots_.resize(slot_count);
    std::vector<bool> is_named(slot_count);
    for (std::size_t i = 0; i < first_ids.size(); ++i) {
        const BodyId id = first_ids[i];
        if (!id || is_named[id.slot - 1] || id.world != first_ids.front().world) refuse_stale(id, i);
        is_named[id.slot - 1] = true;
        slots_[id.slot - 1].generation = id.generation;
    }
    for (const BodyId id : std::views::reverse(first_ids)) free_slots_.push_back(id.slot - 1);
    retired_count_ = slot_count - first_ids.size();
    // Drops the last slot if its generation is 0 (it was never used) and its id comes last: make_slot() would append
    // the same slot.
    if (!free_slots_.empty() && free_slots_.front() + 1 == end() && slots_.back().generation == 0) {
        slots_.pop_back();
        free_slots_.erase(free_slots_.begin());
    }
}

// The functions down to next_ids() look up ids of bodies.

void Bodies::refuse_form(ProxyIndex proxy, const char* form) {
    throw NotSupported("slot " + std::to_string(proxy + 1) + ": its body is no " + form);
}

void Bodies::refuse_stale(BodyId body, const ListIndex& index) {
    throw_misuse(StaleBody(body, index));
}

// Sorts the two proxies, so that both orders of the arguments ask the same question.
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

std::vector<BodyId> Bodies::next_ids() const {
    std::vector<BodyId> result;
    result.reserve(free_slots_.size() + 1);
    for (const ProxyIndex proxy : std::views::reverse(free_slots_)) result.push_back(id_of(proxy));
    result.push_back({end() + 1, 0, world_number_});
    return result;
}

// The functions down to destroy() create, change and destroy bodies.

void Bodies::reserve(std::size_t count) {
    reserved_ = count;
    slots_.reserve(count);
    free_slots_.reserve(count);
}

ProxyIndex Bodies::make_slot(ShapeKind kind) {
    if (free_slots_.empty()) {
        make_room(free_slots_);
        make_room(slots_);
        slots_.emplace_back();
        free_slots_.push_back(end() - 1);
    }
    make_room_for(kind);
    return free_slots_.back();
}

void Bodies::trim() noexcept {
    if (slots_.size() <= trimmed_size_ + trimmed_size_ / 8) return;
    ecods::trim(slots_, reserved_);
    trimmed_size_ = slots_.size();
}

void Bodies::create(const BodyOptions& options, std::shared_ptr<const Shape> shape) noexcept {
    const ProxyIndex proxy = free_slots_.back();
    free_slots_.pop_back();
    Slot& slot = slots_[proxy];
    slot.put(std::move(shape));
    count(slot);
    slot.pose = options.pose;
    slot.filter = options.filter;
    slot.user_data = options.user_data;
}

void Bodies::set_shape(ProxyIndex proxy, std::shared_ptr<const Shape> shape) noexcept {
    Slot& slot = slots_[proxy];
    discount(slot);
    slot.put(std::move(shape));
    count(slot);
}

void Bodies::count(const Slot& slot) noexcept {
    ++kind_counts_[slot.kind];
    without_hits_count_ += !slot.answers_hits;
    solid_count_ += slot.solid() != nullptr;
}

void Bodies::discount(const Slot& slot) noexcept {
    --kind_counts_[slot.kind];
    without_hits_count_ -= !slot.answers_hits;
    solid_count_ -= slot.solid() != nullptr;
}

void Bodies::make_room_to_destroy() {
    make_room(free_slots_);
}

void Bodies::destroy(ProxyIndex proxy) noexcept {
    Slot& slot = slots_[proxy];
    discount(slot);
    slot.shape.reset();
    if (slot.generation != Slot::generation_max) {
        ++slot.generation;
        free_slots_.push_back(proxy);
    } else {
        ++retired_count_;
    }
    disabled_.forget(proxy);
}

// The functions below read the bodies and check them.

std::optional<ShapeKind> Bodies::kind_without_hits() const noexcept {
    std::optional<ShapeKind> least;
    if (without_hits_count_ == 0) return least;
    for (const Slot& slot : slots_) {
        if (slot.is_alive() && !slot.answers_hits && (!least || slot.kind < *least)) least = slot.kind;
    }
    return least;
}

bool Bodies::has_pair_of(ShapeKind a, ShapeKind b) const {
    return a == b ? count_of(a) > 1 : count_of(a) > 0 && count_of(b) > 0;
}

std::size_t Bodies::memory_bytes() const noexcept {
    return bytes_of(slots_, free_slots_) + disabled_.memory_bytes();
}

void Bodies::validate() const {
    std::size_t count = 0, solid_count = 0;
    for (const Slot& slot : slots_) {
        count += slot.is_alive();
        solid_count += slot.is_alive() && slot.solid() != nullptr;
    }
    if (count != alive_count()) throw BrokenInvariant("a slot is neither free nor used");
    if (solid_count != solid_count_) throw BrokenInvariant("solids are not counted right");
}

}  // namespace ecods
