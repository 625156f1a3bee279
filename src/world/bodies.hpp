// The bodies of a world: their places, and what their owner set. Their boxes are in the overlap tracker.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ecods/convex_solid.hpp"
#include "ecods/world.hpp"
#include "trace/mesh_form.hpp"
#include "world/disabled_pairs.hpp"

namespace ecods {

// A place for a body. Slot numbers are the broad phase's proxies; id.slot is one more.
struct Slot {
    static constexpr std::uint16_t generation_max = std::numeric_limits<std::uint16_t>::max();

    std::uint16_t generation = 0;
    bool answers_hits = false;          // the shape
    MeshForm form = MeshForm::surface;  // of the shape, if it is a mesh; of others, surface
    ShapeKind kind;
    std::shared_ptr<const Shape> shape;  // null: free
    Pose pose;
    CollisionFilter filter;
    std::uint64_t user_data = 0;
    std::uint64_t shape_digest = 0;

    bool is_alive() const noexcept { return shape != nullptr; }
    Posed<Shape> posed() const noexcept { return {*shape, pose}; }
    void put(std::shared_ptr<const Shape> new_shape) noexcept;

    // The shape as a solid, as a convex solid, or null.
    const Solid* solid() const noexcept {
        return form != MeshForm::surface ? static_cast<const Solid*>(shape.get()) : nullptr;
    }
    const ConvexSolid* convex() const noexcept {
        return form == MeshForm::convex ? static_cast<const ConvexSolid*>(shape.get()) : nullptr;
    }
};

class Bodies {
  public:
    // Gives these ids first (WorldOptions::ids). Throws StaleBody.
    explicit Bodies(std::span<const BodyId> first_ids);

    // ---- ids
    bool is_alive(BodyId body) const noexcept {
        return body && body.slot <= slots_.size() && slots_[body.slot - 1].is_alive() &&
               slots_[body.slot - 1].generation == body.generation && (body.world == world_number_ || body.world == 0);
    }
    ProxyIndex require(BodyId body, const ListIndex& index = {}) const {  // throws StaleBody
        if (!is_alive(body)) [[unlikely]]
            refuse_stale(body, index);
        return body.slot - 1;
    }
    ProxyPair require_pair(BodyId a, BodyId b) const;  // ... and SameBody; ascending
    BodyId id_of(ProxyIndex proxy) const noexcept { return {proxy + 1, slots_[proxy].generation, world_number_}; }
    BodyPair ids_of(ProxyPair pair) const noexcept { return {id_of(pair.a), id_of(pair.b)}; }
    std::vector<BodyId> ids() const;       // of the living, ascending
    std::vector<BodyId> next_ids() const;  // of those to come

    // ---- slots, free ones included
    const Slot& operator[](ProxyIndex proxy) const noexcept { return slots_[proxy]; }
    Slot& operator[](ProxyIndex proxy) noexcept { return slots_[proxy]; }
    // The body as a solid, or as a convex one. Throw NotSupported.
    Posed<Solid> solid_at(ProxyIndex proxy) const { return posed(proxy, slots_[proxy].solid(), "solid"); }
    Posed<ConvexSolid> convex_at(ProxyIndex proxy) const {
        return posed(proxy, slots_[proxy].convex(), "convex solid");
    }
    ProxyIndex end() const noexcept { return static_cast<ProxyIndex>(slots_.size()); }  // slots are below
    void prefetch(ProxyPair pair) const noexcept {
        constexpr std::size_t line_size = 64;
        for (const Slot* const slot : {&slots_[pair.a], &slots_[pair.b]}) {
            for (std::size_t at = 0; at < sizeof(Slot); at += line_size) {
                __builtin_prefetch(reinterpret_cast<const char*>(slot) + at);
            }
        }
    }
    std::size_t alive_count() const noexcept { return slots_.size() - free_slots_.size() - retired_count_; }

    // ---- coming, changing and going: first what may throw, then what does not
    void reserve(std::size_t count);
    ProxyIndex make_slot(ShapeKind kind);  // the free slot that create() takes next, of a body of this kind
    void trim() noexcept;  // after an update: gives back memory for slots, where an eighth of them is new
    void create(const BodyOptions& options, std::shared_ptr<const Shape> shape) noexcept;
    void make_room_for(ShapeKind kind) { kind_counts_[kind]; }  // before set_shape()
    void set_shape(ProxyIndex proxy, std::shared_ptr<const Shape> shape) noexcept;
    void make_room_to_destroy();
    void destroy(ProxyIndex proxy) noexcept;

    // ---- which pairs are tested at all
    bool is_enabled(ProxyPair pair) const noexcept {
        return may_meet(slots_[pair.a].filter, slots_[pair.b].filter) && !disabled_.contains(pair);
    }
    DisabledPairs& disabled() noexcept { return disabled_; }
    const DisabledPairs& disabled() const noexcept { return disabled_; }

    std::size_t solid_count() const noexcept { return solid_count_; }  // of the living

    // How many of each kind live. Some may be 0.
    const std::map<ShapeKind, std::size_t>& kind_counts() const noexcept { return kind_counts_; }

    // A kind of which a living body's shape does not answer hits: the least one, or nothing. Cost: a constant where all
    // answer.
    std::optional<ShapeKind> kind_without_hits() const noexcept;

    // Whether two bodies are here, one of each kind.
    bool has_pair_of(ShapeKind a, ShapeKind b) const;

    std::size_t memory_bytes() const noexcept;

    // Throws BrokenInvariant unless each slot is free, used or retired.
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

    const std::uint16_t world_number_;  // for ids
    std::vector<Slot> slots_;
    std::vector<ProxyIndex> free_slots_;
    std::size_t reserved_ = 0;
    std::size_t trimmed_size_ = 0;   // slots when they were last trimmed
    std::size_t retired_count_ = 0;  // slots that were used once for each generation: neither free nor used
    std::map<ShapeKind, std::size_t> kind_counts_;  // of living bodies
    std::size_t without_hits_count_ = 0;            // of living bodies
    std::size_t solid_count_ = 0;
    DisabledPairs disabled_;
};

}  // namespace ecods
