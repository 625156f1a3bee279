#include "world/world_impl.hpp"

namespace ecods {

void World::set_filter(BodyId body, const CollisionFilter& filter) {
    Impl& w = impl();
    const ProxyIndex proxy = w.require(body);
    if (w.slots[proxy].filter == filter) return;
    make_room(w.changed);
    w.slots[proxy].filter = filter;
    w.mark_changed(proxy, Change::filter);
    if (w.trace) w.trace->write<calls::SetFilter>(body, filter);
}

CollisionFilter World::filter(BodyId body) const {
    const Impl& w = impl();
    return w.slots[w.require(body)].filter;
}

void World::set_pair_enabled(BodyId a, BodyId b, bool is_enabled) {
    Impl& w = impl();
    const ProxyPair pair = w.require_pair(a, b);
    make_room(w.switched);
    if (!(is_enabled ? w.disabled.erase(pair) : w.disabled.insert(pair))) return;
    w.switched.push_back(pair);
    if (w.trace) w.trace->write<calls::SetPairEnabled>(a, b, is_enabled);
}

bool World::is_pair_enabled(BodyId a, BodyId b) const {
    const Impl& w = impl();
    return !w.disabled.contains(w.require_pair(a, b));
}

}  // namespace ecods
