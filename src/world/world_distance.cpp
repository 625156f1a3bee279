#include "base/double_key.hpp"
#include "ecods/distance.hpp"
#include "world/world_impl.hpp"

namespace ecods {

double World::Impl::distance(ProxyPair pair, QueryMemory& memory) const {
    return ask(pair, [&](auto& t, auto& a, auto& b) { return t.distance(a, b, memory); });
}

double World::distance(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    return w.distance(w.bodies.require_pair(a, b), memory);
}

bool World::within(BodyId a, BodyId b, double d, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    if (!is_from_zero(d)) throw InvalidDistance(d);
    return w.test_within(pair, d, memory);
}

ClosestPoints World::closest(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    ClosestPoints points = w.ask(pair, [&](auto& t, auto& x, auto& y) { return t.closest(x, y, memory); });
    if (w.test_of(pair).swapped != (a.slot - 1 != pair.a)) exchange(points);
    return points;
}

double World::distance(BodyId a, BodyId b) {
    return distance(a, b, impl().workers.caller_memory());
}
bool World::within(BodyId a, BodyId b, double d) {
    return within(a, b, d, impl().workers.caller_memory());
}
ClosestPoints World::closest(BodyId a, BodyId b) {
    return closest(a, b, impl().workers.caller_memory());
}

}  // namespace ecods
