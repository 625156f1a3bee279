#include "world/world_impl.hpp"

namespace ecods {

void World::set_filter(BodyId body, const CollisionFilter& filter) {
    Impl& w = impl();
    const ProxyIndex proxy = w.bodies.require(body);
    if (w.bodies[proxy].filter == filter) return;
    w.changes.make_room_for(1);
    w.bodies[proxy].filter = filter;
    w.changes.mark(proxy, Change::filter);
    if (w.trace) w.trace->write<calls::SetFilter>(body, filter);
}

CollisionFilter World::filter(BodyId body) const {
    const Bodies& bodies = impl().bodies;
    return bodies[bodies.require(body)].filter;
}

void World::set_pair_enabled(BodyId a, BodyId b, bool is_enabled) {
    Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    w.changes.make_room_for_switch();
    DisabledPairs& disabled = w.bodies.disabled();
    if (!(is_enabled ? disabled.erase(pair) : disabled.insert(pair))) return;
    w.changes.mark_switched(pair);
    if (w.trace) w.trace->write<calls::SetPairEnabled>(a, b, is_enabled);
}

bool World::is_pair_enabled(BodyId a, BodyId b) const {
    const Bodies& bodies = impl().bodies;
    return !bodies.disabled().contains(bodies.require_pair(a, b));
}

std::vector<BodyPair> World::disabled_pairs() const {
    const Bodies& bodies = impl().bodies;
    std::vector<BodyPair> result;
    for (const ProxyPair pair : bodies.disabled().list()) result.push_back(bodies.ids_of(pair));
    return result;
}

}  // namespace ecods
