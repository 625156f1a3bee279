#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/double_key.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

constexpr std::int64_t infinity = key_of(std::numeric_limits<double>::infinity());

// The least distance so far, and whose it is: a body or a pair by its number, which decides ties. Distances are keys:
// subnormal numbers are not to be taken for zero.
template <class Number>
class Least {
  public:
    explicit Least(double limit) : limit_(key_of(limit)) {
        if (limit_ < 0 || limit_ > infinity) throw InvalidDistance(limit);
    }

    // Asks for a candidate whether it is within the distance at which it could win, and where it is, for its distance.
    // Returns the limit for what comes.
    //
    // With a rounded distance r it wins if r is less than the least one, or equal and its number is less. Then the real
    // distance is at most the least one in the first case, and the double above that in the second, as what is greater
    // rounds to no less; and in both at most the limit.
    template <class Within, class Distance>
    double take(Number number, const Within& within, const Distance& distance) {
        std::int64_t reach = limit_;
        if (has_number_) {
            const bool wins_ties = number < number_;
            if (distance_ == 0 && !wins_ties) return 0;
            reach = wins_ties && distance_ > 0 ? std::min(limit_, distance_ + 1) : distance_;
        }
        if (reach < infinity && !within(double_of(reach))) return bound();
        const std::int64_t found = key_of(distance());
        if (!has_number_ || found < distance_ || (found == distance_ && number < number_)) {
            has_number_ = true;
            number_ = number;
            distance_ = found;
        }
        return bound();
    }

    double bound() const noexcept { return double_of(has_number_ ? distance_ : limit_); }
    bool has_number() const noexcept { return has_number_; }
    Number number() const noexcept { return number_; }
    double distance() const noexcept { return double_of(distance_); }

  private:
    std::int64_t limit_;
    bool has_number_ = false;
    Number number_{};
    std::int64_t distance_ = 0;
};

std::optional<NearestBody> nearest_of(const Least<ProxyIndex>& least, const Bodies& bodies) {
    if (!least.has_number()) return std::nullopt;
    return NearestBody{bodies.id_of(least.number()), least.distance()};
}

}  // namespace

std::optional<NearestBody> World::nearest(BodyId body, QueryMemory& memory, double limit) const {
    const Impl& w = impl();
    const ProxyIndex own = w.bodies.require(body);
    Least<ProxyIndex> least(limit);
    const Slot& slot = w.bodies[own];
    w.require_tests_for(slot.kind, slot.shape.get(), Question::within);
    w.require_tests_for(slot.kind, slot.shape.get(), Question::distance);
    w.broad_phase.visit_near(w.broad_phase.box(own), limit, [&](ProxyIndex proxy) {
        const ProxyPair pair{std::min(own, proxy), std::max(own, proxy)};
        if (proxy == own || !w.bodies.is_enabled(pair)) return least.bound();
        return least.take(
            proxy, [&](double d) { return w.test_within(pair, d, memory); }, [&] { return w.distance(pair, memory); });
    });
    return nearest_of(least, w.bodies);
}

std::optional<NearestBody> World::nearest(const Shape& shape, const Pose& pose, QueryMemory& memory, double limit,
                                          std::optional<CollisionFilter> filter) const {
    const Impl& w = impl();
    require_mesh_kind(shape);
    require_valid(pose);
    Least<ProxyIndex> least(limit);
    w.require_tests_for(shape.kind(), nullptr, Question::within);
    w.require_tests_for(shape.kind(), nullptr, Question::distance);
    const Posed<Shape> asked(shape, pose);
    w.broad_phase.visit_near(box_for(shape, pose), limit, [&](ProxyIndex proxy) {
        const Slot& slot = w.bodies[proxy];
        if (filter && !may_meet(*filter, slot.filter)) return least.bound();
        const OrderedTest test = w.tests.find(shape.kind(), slot.kind);
        const Posed<Shape> other = slot.posed();
        return least.take(
            proxy,
            [&](double d) {
                return test.ask(asked, other, [&](const TwoBodyTest& t, const Posed<Shape>& a, const Posed<Shape>& b) {
                    return t.within(a, b, d, memory);
                });
            },
            [&] {
                return test.ask(asked, other, [&](const TwoBodyTest& t, const Posed<Shape>& a, const Posed<Shape>& b) {
                    return t.distance(a, b, memory);
                });
            });
    });
    return nearest_of(least, w.bodies);
}

std::optional<NearestBody> World::nearest(const std::shared_ptr<const Mesh>& mesh, const Pose& pose,
                                          QueryMemory& memory, double limit,
                                          std::optional<CollisionFilter> filter) const {
    if (!mesh) throw NullArgument("mesh");
    const auto known = impl().mesh_shapes.find(mesh);
    return known ? nearest(*known, pose, memory, limit, filter) : nearest(MeshShape(mesh), pose, memory, limit, filter);
}

std::optional<ClosestPair> World::closest_pair(QueryMemory& memory, double limit) const {
    const Impl& w = impl();
    Least<ProxyPair> least(limit);
    w.require_answers(Question::within);
    w.require_answers(Question::distance);
    w.broad_phase.visit_near_pairs(limit, [&](ProxyPair pair) {
        if (!w.bodies.is_enabled(pair)) return least.bound();
        return least.take(
            pair, [&](double d) { return w.test_within(pair, d, memory); }, [&] { return w.distance(pair, memory); });
    });
    if (!least.has_number()) return std::nullopt;
    return ClosestPair{w.bodies.ids_of(least.number()), least.distance()};
}

std::optional<NearestBody> World::nearest(BodyId body, double limit) {
    return nearest(body, impl().workers.caller_memory(), limit);
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
    return closest_pair(impl().workers.caller_memory(), limit);
}

}  // namespace ecods
