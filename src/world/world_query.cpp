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
    impl_->build_overlapping();
    return impl_->overlapping;
}
std::span<const BodyPair> World::colliding_pairs() const noexcept {
    return impl_->colliding;
}
std::span<const BodyPair> World::began() const noexcept {
    return impl_->began;
}
std::span<const BodyPair> World::ended() const noexcept {
    return impl_->ended;
}

bool World::intersects(BodyId a, BodyId b) {
    return impl_->test(impl_->require_pair(a, b), impl_->memories[0]);
}

Relation World::relation(BodyId a, BodyId b) {
    Impl& w = *impl_;
    const ProxyPair pair = w.require_pair(a, b);
    return w.test_of(pair).ask(w.slots[pair.a].posed(), w.slots[pair.b].posed(),
                               [&](const TwoBodyTest& t, const PosedShape& x, const PosedShape& y) {
                                   return t.relation(x, y, w.memories[0]);
                               });
}

std::vector<TrianglePair> World::intersecting_triangles(BodyId a, BodyId b) {
    Impl& w = *impl_;
    const ProxyPair pair = w.require_pair(a, b);
    const OrderedTest test = w.test_of(pair);
    auto triangles = test.ask(w.slots[pair.a].posed(), w.slots[pair.b].posed(),
                              [&](const TwoBodyTest& t, const PosedShape& x, const PosedShape& y) {
                                  return t.intersecting_triangles(x, y, w.memories[0]);
                              });
    if (test.swapped != (a.slot - 1 != pair.a)) {
        for (TrianglePair& t : triangles) std::swap(t.a, t.b);
        std::ranges::sort(triangles);
    }
    return triangles;
}

Statistics World::statistics() const {
    const Impl& w = *impl_;
    Statistics statistics = w.statistics;
    statistics.broad_phase = w.broad_phase->counts();
    for (const QueryMemory& memory : w.memories) statistics.queries += memory.counts();
    statistics.body_count = w.slots.size() - w.free_slots.size();
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
    return impl_->digest();
}

}  // namespace ecods
