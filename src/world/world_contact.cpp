#include <algorithm>
#include <utility>

#include "base/limits.hpp"
#include "ecods/contact.hpp"
#include "geometry/feature_key.hpp"
#include "world/world_impl.hpp"

namespace ecods {

// The answer of a test that is registered for the kinds in the other order is turned round.
std::vector<TriangleIntersection> World::intersections(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    w.bodies.require_pair(a, b);
    const Slot &first = w.bodies[a.slot - 1], &second = w.bodies[b.slot - 1];
    const OrderedTest test = w.tests.find(first.kind, second.kind);
    auto found = test.ask(first.posed(), second.posed(), &TwoBodyTest::intersections, memory);
    if (test.swapped) {
        for (TriangleIntersection& each : found) std::swap(each.triangles.a, each.triangles.b);
        std::ranges::sort(found, {}, &TriangleIntersection::triangles);
    }
    return found;
}

std::vector<CloseFeatures> World::close_features(BodyId a, BodyId b, double d, QueryMemory& memory) const {
    const Impl& w = impl();
    w.bodies.require_pair(a, b);
    require_finite_distance(d);
    const Slot &first = w.bodies[a.slot - 1], &second = w.bodies[b.slot - 1];
    const OrderedTest test = w.tests.find(first.kind, second.kind);
    auto found = test.ask(first.posed(), second.posed(), &TwoBodyTest::close_features, d, memory);
    if (test.swapped) {
        for (CloseFeatures& each : found) {
            each.closest = turned(each.closest);
            if (each.direction) *each.direction = -*each.direction;
        }
        std::ranges::stable_sort(found, {}, [](const CloseFeatures& each) { return rank(each.closest); });
    }
    return found;
}

std::vector<TriangleIntersection> World::intersections(BodyId a, BodyId b) {
    return intersections(a, b, impl().workers.caller_memory());
}
std::vector<CloseFeatures> World::close_features(BodyId a, BodyId b, double d) {
    return close_features(a, b, d, impl().workers.caller_memory());
}

}  // namespace ecods
