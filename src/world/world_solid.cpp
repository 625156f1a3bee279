#include <exception>
#include <utility>

#include "query/intersection/asking.hpp"
#include "query/solid/solid_parts.hpp"
#include "world/first_failure.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void World::set_solids(bool are_related) {
    Impl& w = impl();
    if (are_related == w.solids.are_wanted()) return;
    w.solids.set(are_related);
    if (w.trace) w.trace->write<calls::SetSolids>(are_related);
}

bool World::are_solids_related() const {
    return impl().solids.are_wanted();
}

std::span<const SolidPair> World::solid_pairs() const {
    return impl().solids.list();
}

Relation World::Impl::relate(ProxyPair pair, QueryMemory& memory) const {
    return ecods::solid_relation(bodies.solid_at(pair.a), bodies.solid_at(pair.b), memory);
}

// Computes the relation of each of the pairs to be tested, even if one throws. Then throws the error of the least pair
// that threw.
void World::Impl::relate_solids() {
    FirstFailure failure;
    const std::span<SolidPair> pairs = solids.tests();
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
    result.skipped_count = w.bodies.alive_count() - w.bodies.solid_count();
    for (const ProxyIndex proxy : w.broad_phase.find(Aabb{point, point})) {
        const Slot& slot = w.bodies[proxy];
        const Solid* const solid = slot.solid();
        if (solid == nullptr) continue;
        const Side side = locate(point, {*solid, slot.pose}, asking.memory()).side;
        if (side != Side::outside) result.bodies.push_back({w.bodies.id_of(proxy), side});
    }
    return w.traced<calls::BodiesAtPoint>(ask, std::move(result), point);
}

}  // namespace ecods
