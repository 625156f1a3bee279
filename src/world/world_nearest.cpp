#include <algorithm>
#include <limits>

#include "base/limits.hpp"
#include "world/least.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

template <class Name>
Least<Name> least_within(double limit) {
    require_distance(limit);
    return Least<Name>(limit);
}

// Asks for a candidate whether it is within the distance at which it could win, and where it is, for its distance.
// Returns the limit for what comes.
template <class Name, class Within, class Distance>
double take(Least<Name>& least, Name name, const Within& within, const Distance& distance) {
    const auto reach = least.reach(name);
    if (!reach) return least.bound();
    if (*reach < std::numeric_limits<double>::infinity() && !within(*reach)) return least.bound();
    least.take(name, distance());
    return least.bound();
}

std::optional<NearestBody> nearest_of(const Least<ProxyIndex>& least, const Bodies& bodies) {
    if (!least.has_name()) return std::nullopt;
    return NearestBody{bodies.id_of(least.name()), least.number()};
}

}  // namespace

std::optional<NearestBody> World::nearest(BodyId body, QueryMemory& memory, double limit) const {
    const Impl& w = impl();
    const ProxyIndex own = w.bodies.require(body);
    auto least = least_within<ProxyIndex>(limit);
    const Slot& slot = w.bodies[own];
    w.require_tests_for(slot.kind, slot.shape.get(), Question::within);
    w.require_tests_for(slot.kind, slot.shape.get(), Question::distance);
    w.broad_phase.visit_near(w.broad_phase.box(own), limit, [&](ProxyIndex proxy) {
        const ProxyPair pair{std::min(own, proxy), std::max(own, proxy)};
        if (proxy == own || !w.bodies.is_enabled(pair)) return least.bound();
        return take(
            least, proxy, [&](double d) { return w.ask(pair, &TwoBodyTest::within, d, memory); },
            [&] { return w.ask(pair, &TwoBodyTest::distance, memory); });
    });
    return nearest_of(least, w.bodies);
}

std::optional<NearestBody> World::nearest(const Shape& shape, const Pose& pose, QueryMemory& memory, double limit,
                                          std::optional<CollisionFilter> filter) const {
    const Impl& w = impl();
    require_mesh_kind(shape);
    require_valid(pose);
    auto least = least_within<ProxyIndex>(limit);
    w.require_tests_for(shape.kind(), nullptr, Question::within);
    w.require_tests_for(shape.kind(), nullptr, Question::distance);
    const Posed<Shape> asked(shape, pose);
    w.broad_phase.visit_near(box_for(shape, pose), limit, [&](ProxyIndex proxy) {
        const Slot& slot = w.bodies[proxy];
        if (filter && !may_meet(*filter, slot.filter)) return least.bound();
        const OrderedTest test = w.tests.find(shape.kind(), slot.kind);
        const Posed<Shape> other = slot.posed();
        return take(
            least, proxy, [&](double d) { return test.ask(asked, other, &TwoBodyTest::within, d, memory); },
            [&] { return test.ask(asked, other, &TwoBodyTest::distance, memory); });
    });
    return nearest_of(least, w.bodies);
}

std::optional<NearestBody> World::nearest(const std::shared_ptr<const Mesh>& mesh, const Pose& pose,
                                          QueryMemory& memory, double limit,
                                          std::optional<CollisionFilter> filter) const {
    return impl().mesh_shapes.with(mesh,
                                   [&](const MeshShape& shape) { return nearest(shape, pose, memory, limit, filter); });
}

std::optional<ClosestPair> World::closest_pair(QueryMemory& memory, double limit) const {
    const Impl& w = impl();
    auto least = least_within<ProxyPair>(limit);
    w.require_answers(Question::within);
    w.require_answers(Question::distance);
    w.broad_phase.visit_near_pairs(limit, [&](ProxyPair pair) {
        if (!w.bodies.is_enabled(pair)) return least.bound();
        return take(
            least, pair, [&](double d) { return w.ask(pair, &TwoBodyTest::within, d, memory); },
            [&] { return w.ask(pair, &TwoBodyTest::distance, memory); });
    });
    if (!least.has_name()) return std::nullopt;
    return ClosestPair{w.bodies.ids_of(least.name()), least.number()};
}

std::optional<NearestBody> World::nearest(BodyId body, double limit) {
    Impl& w = impl();
    return w.traced<calls::Nearest>(nearest(body, w.workers.caller_memory(), limit), body, limit);
}
std::optional<NearestBody> World::nearest(const Shape& shape, const Pose& pose, double limit,
                                          std::optional<CollisionFilter> filter) {
    return nearest(shape, pose, impl().workers.caller_memory(), limit, filter);
}
std::optional<NearestBody> World::nearest(const std::shared_ptr<const Mesh>& mesh, const Pose& pose, double limit,
                                          std::optional<CollisionFilter> filter) {
    return nearest(mesh, pose, impl().workers.caller_memory(), limit, filter);
}
std::optional<ClosestPair> World::closest_pair(double limit) {
    Impl& w = impl();
    return w.traced<calls::ClosestOfAll>(closest_pair(w.workers.caller_memory(), limit), limit);
}

}  // namespace ecods
