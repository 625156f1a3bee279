#include <algorithm>
#include <utility>

#include "base/hash.hpp"
#include "base/misuse.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

std::uint64_t digest_of(const Slot& slot) {
    std::uint64_t digest = combine(slot.shape->kind().value, slot.shape->digest());
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) digest = combine(digest, coordinate_bits(slot.pose.R(row, column)));
        digest = combine(digest, coordinate_bits(slot.pose.t[row]));
    }
    return digest;
}

}  // namespace

OrderedTest World::Impl::test_of(ProxyPair pair) const {
    return tests.find(slots[pair.a].shape->kind(), slots[pair.b].shape->kind());
}

bool World::Impl::test(ProxyPair pair, QueryMemory& query_memory) const {
    return test_of(pair).ask(slots[pair.a].posed(), slots[pair.b].posed(),
                             [&](const TwoBodyTest& t, const PosedShape& a, const PosedShape& b) {
                                 return t.intersects(a, b, query_memory);
                             });
}

std::span<const BodyPair> World::overlapping_pairs() const noexcept {
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

namespace {

// The pair of two bodies, the smaller slot first, so that either order of arguments asks the very same question.
ProxyPair ordered_pair(ProxyIndex a, ProxyIndex b, BodyId body) {
    if (a == b) throw_misuse(SameBody(body));
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace

bool World::intersects(BodyId a, BodyId b) {
    return impl_->test(ordered_pair(impl_->require(a), impl_->require(b), a), impl_->memory);
}

Relation World::relation(BodyId a, BodyId b) {
    Impl& w = *impl_;
    const ProxyPair pair = ordered_pair(w.require(a), w.require(b), a);
    return w.test_of(pair).ask(
        w.slots[pair.a].posed(), w.slots[pair.b].posed(),
        [&](const TwoBodyTest& t, const PosedShape& x, const PosedShape& y) { return t.relation(x, y, w.memory); });
}

std::vector<TrianglePair> World::touching_triangles(BodyId a, BodyId b) {
    Impl& w = *impl_;
    const ProxyIndex first = w.require(a);
    const ProxyPair pair = ordered_pair(first, w.require(b), a);
    const OrderedTest test = w.test_of(pair);
    auto triangles = test.ask(w.slots[pair.a].posed(), w.slots[pair.b].posed(),
                              [&](const TwoBodyTest& t, const PosedShape& x, const PosedShape& y) {
                                  return t.touching_triangles(x, y, w.memory);
                              });
    if (test.swapped != (first != pair.a)) {
        for (TrianglePair& t : triangles) std::swap(t.a, t.b);
        std::ranges::sort(triangles);
    }
    return triangles;
}

Statistics World::statistics() const {
    Statistics statistics = impl_->statistics;
    statistics.broad_phase = impl_->broad_phase->counts();
    statistics.queries = impl_->memory.counts();
    for (const auto& [kind, count] : impl_->kind_counts) statistics.body_count += count;
    statistics.overlapping_count = impl_->overlapping.size();
    statistics.colliding_count = impl_->colliding.size();
    return statistics;
}

// Sums of words that are themselves mixed: the order of bodies and pairs does not matter.
std::uint64_t World::digest() const {
    const Impl& w = *impl_;
    std::uint64_t bodies = 0;
    for (const Slot& slot : w.slots) {
        if (slot.is_alive()) bodies += mix(digest_of(slot));
    }
    std::uint64_t pairs = 0;
    for (const BodyPair& pair : w.colliding) {
        if (!is_alive(pair.a) || !is_alive(pair.b)) continue;
        const std::uint64_t a = digest_of(w.slots[pair.a.slot - 1]);
        const std::uint64_t b = digest_of(w.slots[pair.b.slot - 1]);
        pairs += mix(combine(std::min(a, b), std::max(a, b)));
    }
    return combine(bodies, pairs);
}

}  // namespace ecods
