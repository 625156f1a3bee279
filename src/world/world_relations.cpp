#include <exception>
#include <utility>

#include "query/intersection/asking.hpp"
#include "query/solid/relations.hpp"
#include "query/solid/solid_parts.hpp"
#include "world/first_failure.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void World::set_relations(bool are_listed) {
    Impl& w = impl();
    if (are_listed == w.relations.are_wanted()) return;
    if (are_listed) w.require_answers(Question::relation);
    w.relations.set(are_listed);
    if (w.trace) w.trace->write<calls::SetRelations>(are_listed);
}

bool World::are_relations_listed() const {
    return impl().relations.are_wanted();
}

std::span<const PairRelation> World::relations() const {
    return impl().relations.list();
}

Relation World::Impl::relate(ProxyPair pair, QueryMemory& memory) const {
    if (relations.is_of_solids()) {
        return solid_relation(bodies.solid_at(pair.a), bodies.solid_at(pair.b), memory);
    }
    const Relation found = ask(pair, &TwoBodyTest::relation, Ask(memory));
    return test_of(pair).swapped ? mirrored(found) : found;
}

// Computes the relation of each of the pairs to be tested, even if one throws. Then throws the error of the least pair
// that threw.
void World::Impl::relate_pairs() {
    FirstFailure failure;
    const std::span<PairRelation> pairs = relations.tests();
    workers.run(pairs.size(), [&](std::size_t at, QueryMemory& memory) {
        const BodyPair& ids = pairs[at].bodies;
        try {
            pairs[at].relation = relate({ids.a.slot - 1, ids.b.slot - 1}, memory);
        } catch (...) {
            failure.keep(ids, std::current_exception());
        }
    });
    failure.rethrow();
}

BodiesContaining World::bodies_containing(const Vec3& point, const Ask& ask) const {
    const Impl& w = impl();
    require_valid(point);
    Asking asking(ask);
    BodiesContaining result;
    result.skipped_count = w.bodies.alive_count() - w.bodies.solid_count() - w.bodies.count_of(ShapeKind::rounded()) -
                           w.bodies.count_of(ShapeKind::rounded_convex());
    for (const ProxyIndex proxy : w.broad_phase.find(Aabb{point, point})) {
        const Slot& slot = w.bodies[proxy];
        Side side = Side::outside;
        if (const Solid* const solid = slot.solid()) {
            side = locate(point, {*solid, slot.pose}, asking.memory()).side;
        } else if (const Rounded* const rounded = slot.rounded()) {
            side = locate(point, Posed<Rounded>(*rounded, slot.pose), asking.memory()).side;
        }
        if (side != Side::outside) result.bodies.push_back({w.bodies.id_of(proxy), side});
    }
    return w.traced<calls::BodiesAtPoint>(ask, std::move(result), point);
}

}  // namespace ecods
