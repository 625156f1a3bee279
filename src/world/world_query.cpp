#include <algorithm>
#include <utility>

#include "base/hash.hpp"
#include "query/intersection/asking.hpp"
#include "query/solid/relations.hpp"
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
    return impl().collisions.overlapping();
}
std::span<const BodyPair> World::colliding_pairs() const {
    return impl().collisions.positive();
}
std::span<const BodyPair> World::began() const {
    return impl().collisions.began();
}
std::span<const BodyPair> World::ended() const {
    return impl().collisions.ended();
}

bool World::intersects(const Asked& a, const Asked& b, const Ask& ask) const {
    Asking asking(ask);
    return impl().pair_of(a, b).ask(&TwoBodyTest::intersects, Ask(asking.memory(), asking.witness()));
}

Relation World::relation(const Asked& a, const Asked& b, const Ask& ask) const {
    const SubjectPair pair = impl().pair_of(a, b);
    const Relation found = pair.ask(&TwoBodyTest::relation, Ask(Asking(ask).memory()));
    return pair.test.swapped ? mirrored(found) : found;
}

// Returns the pairs of intersecting triangles. If the test takes the shapes in the other order, exchanges the two
// triangles of each pair in the result.
std::vector<TrianglePair> World::intersecting_triangles(const Asked& a, const Asked& b, const Ask& ask) const {
    const SubjectPair pair = impl().pair_of(a, b);
    auto triangles = pair.ask(&TwoBodyTest::intersecting_triangles, Ask(Asking(ask).memory()));
    if (pair.test.swapped) {
        for (TrianglePair& t : triangles) std::swap(t.a, t.b);
        std::ranges::sort(triangles);
    }
    return triangles;
}

std::vector<TriangleIntersection> World::intersections(const Asked& a, const Asked& b, const Ask& ask) const {
    const SubjectPair pair = impl().pair_of(a, b);
    auto found = pair.ask(&TwoBodyTest::intersections, Ask(Asking(ask).memory()));
    if (pair.test.swapped) {
        for (TriangleIntersection& each : found) std::swap(each.triangles.a, each.triangles.b);
        std::ranges::sort(found, {}, &TriangleIntersection::triangles);
    }
    return found;
}

Statistics World::statistics() const {
    const Impl& w = impl();
    Statistics statistics = w.statistics;
    statistics.broad_phase = w.broad_phase.counts();
    statistics.queries = w.workers.counts();
    statistics.clearance = w.closeness.statistics();
    statistics.body_count = w.bodies.alive_count();
    statistics.overlapping_count = w.collisions.verdicts().enabled_count();
    statistics.filtered_count = w.collisions.verdicts().size() - statistics.overlapping_count;
    statistics.colliding_count = w.collisions.positive().size();
    statistics.memory_bytes = w.bodies.memory_bytes() + w.changes.memory_bytes() + w.collisions.memory_bytes() +
                              w.closeness.memory_bytes() + w.relations.memory_bytes();
    return statistics;
}

namespace {

// Sums the digests of the pairs whose bodies are both alive.
std::uint64_t sum_of_pairs(const BodyPairs& pairs, const Bodies& bodies) {
    std::uint64_t sum = 0;
    for (const BodyPair& pair : pairs) {
        if (!bodies.is_alive(pair.a) || !bodies.is_alive(pair.b)) continue;
        const std::uint64_t a = digest_of(bodies[pair.a.slot - 1]);
        const std::uint64_t b = digest_of(bodies[pair.b.slot - 1]);
        sum += mix(combine(std::min(a, b), std::max(a, b)));
    }
    return sum;
}

// Returns the number of a relation in digests of version 1, which had no number for `crossing`.
std::uint64_t number_of(Relation relation) noexcept {
    return static_cast<std::uint64_t>(relation) - (relation > Relation::crossing ? 1 : 0);
}

// Sums the digests of the pairs whose bodies are both alive. The body with the lesser digest counts as the first of its
// pair, so the sum does not depend on ids.
std::uint64_t sum_of_relations(const PairRelations& relations, const Bodies& bodies) {
    std::uint64_t sum = 0;
    for (const PairRelation& pair : relations.list()) {
        if (!bodies.is_alive(pair.bodies.a) || !bodies.is_alive(pair.bodies.b)) continue;
        const std::uint64_t a = digest_of(bodies[pair.bodies.a.slot - 1]);
        const std::uint64_t b = digest_of(bodies[pair.bodies.b.slot - 1]);
        const Relation relation = a <= b ? pair.relation : mirrored(pair.relation);
        const auto [low, high] = std::minmax(a, b);
        sum += mix(combine(combine(low, high),
                           relations.is_of_solids() ? number_of(relation) : static_cast<std::uint64_t>(relation)));
    }
    return sum;
}

}  // namespace

// Returns a digest of the bodies and of the listed pairs. The digest is a sum of words that are already mixed, so the
// order of bodies and pairs does not matter.
std::uint64_t World::Impl::digest() const {
    std::uint64_t sum_of_bodies = 0;
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        if (bodies[proxy].is_alive()) sum_of_bodies += mix(digest_of(bodies[proxy]));
    }
    std::uint64_t digest = combine(sum_of_bodies, sum_of_pairs(collisions.positive(), bodies));
    if (relations.are_listed()) digest = combine(digest, sum_of_relations(relations, bodies));
    if (!closeness.listed()) return digest;
    return combine(digest,
                   combine(coordinate_bits(*closeness.listed()), sum_of_pairs(closeness.pairs().positive(), bodies)));
}

std::uint64_t World::digest() const {
    return impl().digest();
}

}  // namespace ecods
