#include <algorithm>
#include <utility>

#include "base/hash.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

std::uint64_t digest_of(const Slot& slot) {
    std::uint64_t digest = combine(slot.kind.value, slot.shape_digest);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) digest = combine(digest, coordinate_bits(slot.pose.R(row, column)));
        digest = combine(digest, coordinate_bits(slot.pose.t[row]));
    }
    return digest;
}

}  // namespace

std::span<const BodyPair> World::overlapping_pairs() {
    Impl& w = impl();
    w.build_overlapping();
    return w.overlapping;
}
std::span<const BodyPair> World::colliding_pairs() const {
    return impl().colliding;
}
std::span<const BodyPair> World::began() const {
    return impl().began;
}
std::span<const BodyPair> World::ended() const {
    return impl().ended;
}

bool World::intersects(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    return w.test(w.require_pair(a, b), memory);
}

Relation World::relation(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.require_pair(a, b);
    return w.test_of(pair).ask(
        w.slots[pair.a].posed(), w.slots[pair.b].posed(),
        [&](const TwoBodyTest& t, const Posed<Shape>& x, const Posed<Shape>& y) { return t.relation(x, y, memory); });
}

std::vector<TrianglePair> World::intersecting_triangles(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.require_pair(a, b);
    const OrderedTest test = w.test_of(pair);
    auto triangles = test.ask(w.slots[pair.a].posed(), w.slots[pair.b].posed(),
                              [&](const TwoBodyTest& t, const Posed<Shape>& x, const Posed<Shape>& y) {
                                  return t.intersecting_triangles(x, y, memory);
                              });
    if (test.swapped != (a.slot - 1 != pair.a)) {
        for (TrianglePair& t : triangles) std::swap(t.a, t.b);
        std::ranges::sort(triangles);
    }
    return triangles;
}

bool World::intersects(BodyId a, BodyId b) {
    return intersects(a, b, impl().memories[0]);
}
Relation World::relation(BodyId a, BodyId b) {
    return relation(a, b, impl().memories[0]);
}
std::vector<TrianglePair> World::intersecting_triangles(BodyId a, BodyId b) {
    return intersecting_triangles(a, b, impl().memories[0]);
}

Statistics World::statistics() const {
    const Impl& w = impl();
    Statistics statistics = w.statistics;
    statistics.broad_phase = w.broad_phase->counts();
    for (const QueryMemory& memory : w.memories) statistics.queries += memory.counts();
    statistics.body_count = w.slots.size() - w.free_slots.size() - w.retired_count;
    statistics.overlapping_count = w.verdicts.enabled_count();
    statistics.filtered_count = w.verdicts.size() - w.verdicts.enabled_count();
    statistics.colliding_count = w.colliding.size();
    statistics.memory_bytes = w.memory_bytes();
    return statistics;
}

std::size_t World::Impl::memory_bytes() const noexcept {
    const auto bytes = [](const auto&... lists) { return ((lists.capacity() * sizeof(lists[0])) + ...); };
    return bytes(slots, boxes, changes, free_slots, changed, switched, pair_tests, lost, overlapping, colliding, began,
                 ended, next_began, next_ended) +
           verdicts.memory_bytes() + disabled.memory_bytes();
}

// Sums of words that are themselves mixed: the order of bodies and pairs does not matter.
std::uint64_t World::Impl::digest() const {
    std::uint64_t bodies = 0;
    for (const Slot& slot : slots) {
        if (slot.is_alive()) bodies += mix(digest_of(slot));
    }
    std::uint64_t pairs = 0;
    for (const BodyPair& pair : colliding) {
        if (!is_alive(pair.a) || !is_alive(pair.b)) continue;
        const std::uint64_t a = digest_of(slots[pair.a.slot - 1]);
        const std::uint64_t b = digest_of(slots[pair.b.slot - 1]);
        pairs += mix(combine(std::min(a, b), std::max(a, b)));
    }
    return combine(bodies, pairs);
}

std::uint64_t World::digest() const {
    return impl().digest();
}

}  // namespace ecods
