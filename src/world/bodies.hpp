// Stores the bodies of a world in slots, with everything that the caller set for each body. The boxes of the bodies are
// not here: the overlap tracker stores them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ecods/rounded.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "trace/mesh_form.hpp"
#include "world/disabled_pairs.hpp"

namespace ecods {

// Returns true if a shape of this kind is a Rounded: World refuses any other shape of these kinds (require_own_kind).
constexpr bool is_rounded(ShapeKind kind) noexcept {
    return kind == ShapeKind::rounded() || kind == ShapeKind::rounded_convex();
}

// A slot holds one body at a time, or is free. The index of a slot is the proxy of its body in the broad phase;
// BodyId::slot is that index plus one.
struct Slot {
    static constexpr std::uint16_t generation_max = std::numeric_limits<std::uint16_t>::max();

    std::uint16_t generation = 0;
    bool answers_hits = false;          // true if the shape answers Question::hits
    MeshForm form = MeshForm::surface;  // surface also for a shape that is not a mesh
    ShapeKind kind;
    std::shared_ptr<const Shape> shape;  // null: the slot is free
    Pose pose;
    CollisionFilter filter;
    std::uint64_t user_data = 0;
    std::uint64_t shape_digest = 0;

    bool is_alive() const noexcept { return shape != nullptr; }
    Posed<Shape> posed() const noexcept { return {*shape, pose}; }
    void put(std::shared_ptr<const Shape> new_shape) noexcept;

    // Return the shape as a Solid, as a ConvexSolid or as a Rounded; null if the shape is of another class.
    const Solid* solid() const noexcept {
        return form != MeshForm::surface ? static_cast<const Solid*>(shape.get()) : nullptr;
    }
    const ConvexSolid* convex() const noexcept {
        return form == MeshForm::convex ? static_cast<const ConvexSolid*>(shape.get()) : nullptr;
    }
    const Rounded* rounded() const noexcept {
        return is_alive() && is_rounded(kind) ? static_cast<const Rounded*>(shape.get()) : nullptr;
    }
};

class Bodies {
  public:
    // Makes `first_ids` the ids of the bodies that will be created first, in this order (see WorldOptions::ids). Throws
    // StaleBody if these ids could not have been given by one world.
    explicit Bodies(std::span<const BodyId> first_ids);

    // The functions down to next_ids() look up ids of bodies.
    bool is_alive(BodyId body) const noexcept {
        return body && body.slot <= slots_.size() && slots_[body.slot - 1].is_alive() &&
               slots_[body.slot - 1].generation == body.generation && (body.world == world_number_ || body.world == 0);
    }
    ProxyIndex require(BodyId body,
                       const ListIndex& index = {}) const {  // returns the proxy of the body; throws StaleBody
        if (!is_alive(body)) [[unlikely]]
            refuse_stale(body, index);
        return body.slot - 1;
    }
    ProxyPair require_pair(BodyId a, BodyId b) const;  // ascending; throws StaleBody, SameBody
    BodyId id_of(ProxyIndex proxy) const noexcept { return {proxy + 1, slots_[proxy].generation, world_number_}; }
    BodyPair ids_of(ProxyPair pair) const noexcept { return {id_of(pair.a), id_of(pair.b)}; }
    std::vector<BodyId> ids() const;       // all living bodies, ascending
    std::vector<BodyId> next_ids() const;  // see World::next_ids

    // The functions down to alive_count() give access to slots; free slots are included.
    const Slot& operator[](ProxyIndex proxy) const noexcept { return slots_[proxy]; }
    Slot& operator[](ProxyIndex proxy) noexcept { return slots_[proxy]; }
    // Return the body as a solid and as a convex solid. Throw NotSupported if its shape is no solid, or no convex
    // solid.
    Posed<Solid> solid_at(ProxyIndex proxy) const { return posed(proxy, slots_[proxy].solid(), "solid"); }
    Posed<ConvexSolid> convex_at(ProxyIndex proxy) const {
        return posed(proxy, slots_[proxy].convex(), "convex solid");
    }
    ProxyIndex end() const noexcept { return static_cast<ProxyIndex>(slots_.size()); }  // one past the last slot
    void prefetch(ProxyPair pair) const noexcept {
        constexpr std::size_t line_size = 64;
        for (const Slot* const slot : {&slots_[pair.a], &slots_[pair.b]}) {
            for (std::size_t at = 0; at < sizeof(Slot); at += line_size) {
                __builtin_prefetch(reinterpret_cast<const char*>(slot) + at);
            }
        }
    }
    std::size_t alive_count() const noexcept { return slots_.size() - free_slots_.size() - retired_count_; }

    // The functions down to destroy() create, change and destroy bodies. Call the functions that may throw before the
    // noexcept functions.
    void reserve(std::size_t count);
    ProxyIndex make_slot(ShapeKind kind);  // returns the free slot that create() will fill, for a body of this kind
    void trim() noexcept;                  // frees spare memory if the number of slots has grown by an eighth
    void create(const BodyOptions& options, std::shared_ptr<const Shape> shape) noexcept;
    void make_room_for(ShapeKind kind) { kind_counts_[kind]; }  // must be called before set_shape()
    void set_shape(ProxyIndex proxy, std::shared_ptr<const Shape> shape) noexcept;
    void make_room_to_destroy();
    void destroy(ProxyIndex proxy) noexcept;

    // The functions down to disabled() decide which pairs are filtered out.
    bool is_enabled(ProxyPair pair) const noexcept {
        return may_meet(slots_[pair.a].filter, slots_[pair.b].filter) && !disabled_.contains(pair);
    }
    DisabledPairs& disabled() noexcept { return disabled_; }
    const DisabledPairs& disabled() const noexcept { return disabled_; }

    std::size_t solid_count() const noexcept { return solid_count_; }  // living bodies that are solids

    // Returns the number of living bodies of a kind.
    std::size_t count_of(ShapeKind kind) const {
        const auto found = kind_counts_.find(kind);
        return found == kind_counts_.end() ? 0 : found->second;
    }
    bool has_rounded() const { return count_of(ShapeKind::rounded()) + count_of(ShapeKind::rounded_convex()) > 0; }
    // Returns the number of living bodies by kind. A kind without living bodies may be listed, with 0.
    const std::map<ShapeKind, std::size_t>& kind_counts() const noexcept { return kind_counts_; }

    // Returns true if is_allowed(kind) is true for the kinds of all living bodies. Cost: a pass over the kinds.
    template <class Function>
    bool have_kinds(const Function& is_allowed) const {
        return std::ranges::all_of(kind_counts_,
                                   [&](const auto& each) { return each.second == 0 || is_allowed(each.first); });
    }
    bool are_meshes() const {
        return have_kinds([](ShapeKind kind) { return kind == ShapeKind::mesh(); });
    }

    // Returns the least kind that has a living body whose shape does not answer Question::hits; nullopt if all shapes
    // answer it. Cost: constant if all answer it, otherwise one pass over the slots.
    std::optional<ShapeKind> kind_without_hits() const noexcept;

    // Returns true if there are two distinct living bodies, one of kind a and one of kind b.
    bool has_pair_of(ShapeKind a, ShapeKind b) const;

    std::size_t memory_bytes() const noexcept;

    // Throws BrokenInvariant unless each slot is free, used or retired, and the count of solids is right.
    void validate() const;

  private:
    template <class S>
    Posed<S> posed(ProxyIndex proxy, const S* solid, const char* form) const {
        if (solid == nullptr) [[unlikely]]
            refuse_form(proxy, form);
        return {*solid, slots_[proxy].pose};
    }
    [[noreturn]] static void refuse_form(ProxyIndex proxy, const char* form);
    [[noreturn]] static void refuse_stale(BodyId body, const ListIndex& index);
    void count(const Slot& slot) noexcept;
    void discount(const Slot& slot) noexcept;

    const std::uint16_t world_number_;  // BodyId::world of all ids that this world gives
    std::vector<Slot> slots_;
    std::vector<ProxyIndex> free_slots_;
    std::size_t reserved_ = 0;
    std::size_t trimmed_size_ = 0;                  // number of slots when they were last trimmed
    std::size_t retired_count_ = 0;                 // slots whose generations are used up: neither free nor used
    std::map<ShapeKind, std::size_t> kind_counts_;  // number of living bodies of each kind
    std::size_t without_hits_count_ = 0;            // number of living bodies whose shapes do not answer Question::hits
    std::size_t solid_count_ = 0;
    DisabledPairs disabled_;
};

}  // namespace ecods
