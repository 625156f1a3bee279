#include <algorithm>
#include <string>

#include "geometry/key_box.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

std::string text(const BodyPair& pair) {
    const auto one = [](BodyId body) { return std::to_string(body.slot) + "." + std::to_string(body.generation); };
    return "bodies " + one(pair.a) + " and " + one(pair.b);
}

void require(bool holds, const std::string& what) {
    if (!holds) throw BrokenInvariant(what);
}

// The pairs of living bodies whose boxes overlap, found by a path of its own: sorted along one axis and swept.
std::vector<ProxyPair> pairs_of_boxes(const std::vector<Slot>& slots, const std::vector<Aabb>& boxes) {
    struct Box {
        KeyBox keys;
        ProxyIndex proxy;
    };
    std::vector<Box> sorted;
    for (ProxyIndex proxy = 0; proxy < slots.size(); ++proxy) {
        if (slots[proxy].is_alive()) sorted.push_back({key_box(boxes[proxy]), proxy});
    }
    std::ranges::sort(sorted, {}, [](const Box& box) { return box.keys.min[0]; });
    std::vector<ProxyPair> pairs;
    for (auto a = sorted.begin(); a != sorted.end(); ++a) {
        for (auto b = a + 1; b != sorted.end() && b->keys.min[0] <= a->keys.max[0]; ++b) {
            if (!overlap(a->keys, b->keys)) continue;
            pairs.push_back({std::min(a->proxy, b->proxy), std::max(a->proxy, b->proxy)});
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

// A mesh cannot change, and its box depends on the rounding mode; what a caller's shape says is asked again.
void require_unchanged(const Slot& slot, const Aabb& box, BodyId body) {
    if (slot.kind == ShapeKind::mesh()) return;
    if (slot.shape->kind() != slot.kind) throw ShapeChanged(body, slot.kind, "kind");
    if (slot.shape->digest() != slot.shape_digest) throw ShapeChanged(body, slot.kind, "digest");
    if (!(slot.shape->box(slot.pose) == box)) throw ShapeChanged(body, slot.kind, "box");
}

}  // namespace

void World::validate() const {
    const Impl& w = impl();
    std::size_t alive_count = 0;
    for (ProxyIndex proxy = 0; proxy < w.slots.size(); ++proxy) {
        const Slot& slot = w.slots[proxy];
        if (!slot.is_alive()) continue;
        ++alive_count;
        require_unchanged(slot, w.boxes[proxy], w.id_of(proxy));
        require(w.boxes[proxy] == w.broad_phase->box(proxy), "the broad phase has another box than its body");
    }
    require(alive_count == w.broad_phase->size(), "the broad phase has another number of bodies");
    require(alive_count + w.free_slots.size() + w.retired_count == w.slots.size(), "a slot is neither free nor used");
    w.broad_phase->validate();
    w.verdicts.validate();

    const auto pairs = pairs_of_boxes(w.slots, w.boxes);
    require(w.verdicts.size() == pairs.size(), "the cache has another number of pairs than boxes overlap");
    QueryMemory memory;
    std::vector<BodyPair> overlapping, colliding;
    for (const ProxyPair pair : pairs) {
        const BodyPair bodies = w.ids_of(pair);
        const VerdictIndex index = w.verdicts.find(pair);
        require(index != no_verdict && w.verdicts[index].bodies == bodies, text(bodies) + " have no verdict");
        const Verdict& verdict = w.verdicts[index];
        require(verdict.is_enabled == w.is_enabled(pair), text(bodies) + " are filtered wrongly");
        if (!verdict.is_enabled) continue;
        overlapping.push_back(bodies);
        require(verdict.is_colliding == w.test(pair, memory), text(bodies) + " have a stale verdict");
        if (verdict.is_colliding) colliding.push_back(bodies);
    }
    require(w.overlapping_is_stale || overlapping == w.overlapping, "the list of overlapping pairs is wrong");
    require(colliding == w.colliding, "the list of colliding pairs is not that of the verdicts");
}

}  // namespace ecods
