#include <utility>

#include "base/limits.hpp"
#include "ecods/distance.hpp"
#include "world/world_impl.hpp"

namespace ecods {

double World::distance(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    return w.ask(w.bodies.require_pair(a, b), &TwoBodyTest::distance, memory);
}

bool World::within(BodyId a, BodyId b, double d, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    require_distance(d);
    return w.ask(pair, &TwoBodyTest::within, d, memory);
}

ClosestPoints World::closest(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    const ClosestPoints points = w.ask(pair, &TwoBodyTest::closest, memory);
    return w.test_of(pair).swapped != (a.slot - 1 != pair.a) ? turned(points) : points;
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
