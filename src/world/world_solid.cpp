#include <exception>

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

SolidRelation World::Impl::relate(ProxyPair pair, QueryMemory& memory) const {
    return ecods::solid_relation(bodies.solid_at(pair.a), bodies.solid_at(pair.b), memory);
}

// All pairs are related, also when one throws.
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

SolidRelation World::solid_relation(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    const SolidRelation relation = w.relate(pair, memory);
    return a.slot - 1 == pair.a ? relation : mirrored(relation);
}

SolidRelation World::solid_relation(BodyId a, BodyId b) {
    return solid_relation(a, b, impl().workers.caller_memory());
}

BodiesContaining World::bodies_containing(const Vec3& point, QueryMemory& memory) const {
    const Impl& w = impl();
    require_valid(point);
    BodiesContaining result;
    result.skipped_count = w.bodies.alive_count() - w.bodies.solid_count();
    for (const ProxyIndex proxy : w.broad_phase.find(Aabb{point, point})) {
        const Slot& slot = w.bodies[proxy];
        const Solid* const solid = slot.solid();
        if (solid == nullptr) continue;
        const Side side = locate(point, {*solid, slot.pose}, memory).side;
        if (side != Side::outside) result.bodies.push_back({w.bodies.id_of(proxy), side});
    }
    return result;
}

BodiesContaining World::bodies_containing(const Vec3& point) {
    Impl& w = impl();
    return w.traced<calls::BodiesAtPoint>(bodies_containing(point, w.workers.caller_memory()), point);
}

}  // namespace ecods
