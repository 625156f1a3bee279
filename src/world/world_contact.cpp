#include <algorithm>
#include <tuple>
#include <utility>

#include "base/double_key.hpp"
#include "ecods/contact.hpp"
#include "geometry/find_invalid.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// The order of contact.hpp.
bool comes_before(const CloseFeatures& x, const CloseFeatures& y) {
    const auto rank = [](const ClosestPoints& c) {
        return std::tuple(c.kind, c.a.triangle, c.a.corner, c.b.triangle, c.b.corner, c.a.kind);
    };
    return rank(x.closest) < rank(y.closest);
}

}  // namespace

// The answer of a test that is registered for the kinds in the other order is turned round.
std::vector<TriangleIntersection> World::intersections(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    w.bodies.require_pair(a, b);
    const Slot &first = w.bodies[a.slot - 1], &second = w.bodies[b.slot - 1];
    const OrderedTest test = w.tests.find(first.kind, second.kind);
    auto found = test.ask(first.posed(), second.posed(),
                          [&](auto& t, auto& x, auto& y) { return t.intersections(x, y, memory); });
    if (test.swapped) {
        for (TriangleIntersection& each : found) std::swap(each.triangles.a, each.triangles.b);
        std::ranges::sort(found, {}, &TriangleIntersection::triangles);
    }
    return found;
}

std::vector<CloseFeatures> World::close_features(BodyId a, BodyId b, double d, QueryMemory& memory) const {
    const Impl& w = impl();
    w.bodies.require_pair(a, b);
    if (!is_from_zero(d) || !is_finite(d)) throw InvalidDistance(d);
    const Slot &first = w.bodies[a.slot - 1], &second = w.bodies[b.slot - 1];
    const OrderedTest test = w.tests.find(first.kind, second.kind);
    auto found = test.ask(first.posed(), second.posed(),
                          [&](auto& t, auto& x, auto& y) { return t.close_features(x, y, d, memory); });
    if (test.swapped) {
        for (CloseFeatures& each : found) {
            exchange(each.closest);
            if (each.direction) *each.direction = -*each.direction;
        }
        std::ranges::stable_sort(found, comes_before);
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
