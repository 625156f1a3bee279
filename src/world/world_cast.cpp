#include <algorithm>
#include <utility>

#include "base/limits.hpp"
#include "base/make_error.hpp"
#include "ecods/motion.hpp"
#include "world/least.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// The body that is met first so far.
class FirstMet {
  public:
    explicit FirstMet(double time_max) : least_(std::min(time_max, 1.0)) {}

    // `ask(time_max)` gives the contact with a body, if there is one up to then. Returns the limit for what comes.
    template <class Ask>
    double take(ProxyIndex proxy, const Ask& ask) {
        const auto reach = least_.reach(proxy);
        if (!reach) return least_.bound();
        const std::optional<FirstContact> contact = ask(*reach);
        if (contact && least_.take(proxy, contact->time)) contact_ = *contact;
        return least_.bound();
    }
    double bound() const noexcept { return least_.bound(); }
    std::optional<BodyContact> answer(const Bodies& bodies) const {
        if (!least_.has_name()) return std::nullopt;
        return BodyContact{bodies.id_of(least_.name()), contact_};
    }

  private:
    Least<ProxyIndex> least_;
    FirstContact contact_;
};

FirstMet first_met(const Vec3& motion, double time_max) {
    validate_motion(motion);
    if (!is_from_zero(time_max)) throw invalid_time(time_max);
    return FirstMet(time_max);
}

// `a` moves. Where the test has it second, the other one moves the other way, which is the same contact.
std::optional<FirstContact> cast_of(const OrderedTest& test, const Posed<Shape>& a, const Vec3& motion,
                                    const Posed<Shape>& b, double time_max, QueryMemory& memory) {
    if (!test.swapped) return test.test->cast(a, motion, b, time_max, memory);
    auto contact = test.test->cast(b, -motion, a, time_max, memory);
    if (contact) std::swap(contact->a, contact->b);
    return contact;
}

}  // namespace

std::optional<BodyContact> World::cast(BodyId body, const Vec3& motion, QueryMemory& memory, double time_max) const {
    const Impl& w = impl();
    const ProxyIndex own = w.bodies.require(body);
    FirstMet first = first_met(motion, time_max);
    const Slot& slot = w.bodies[own];
    w.require_tests_for(slot.kind, slot.shape.get(), Question::cast);
    w.broad_phase.visit_along(w.broad_phase.box(own), motion, first.bound(), [&](ProxyIndex proxy) {
        if (proxy == own || !w.bodies.is_enabled(ordered_pair(own, proxy))) return first.bound();
        const Slot& other = w.bodies[proxy];
        return first.take(proxy, [&](double limit) {
            return cast_of(w.tests.find(slot.kind, other.kind), slot.posed(), motion, other.posed(), limit, memory);
        });
    });
    return first.answer(w.bodies);
}

std::optional<BodyContact> World::cast(const Shape& shape, const Pose& pose, const Vec3& motion, QueryMemory& memory,
                                       double time_max, std::optional<CollisionFilter> filter) const {
    const Impl& w = impl();
    require_mesh_kind(shape);
    require_valid(pose);
    FirstMet first = first_met(motion, time_max);
    w.require_tests_for(shape.kind(), nullptr, Question::cast);
    const Posed<Shape> asked(shape, pose);
    w.broad_phase.visit_along(box_for(shape, pose), motion, first.bound(), [&](ProxyIndex proxy) {
        const Slot& slot = w.bodies[proxy];
        if (filter && !may_meet(*filter, slot.filter)) return first.bound();
        return first.take(proxy, [&](double limit) {
            return cast_of(w.tests.find(shape.kind(), slot.kind), asked, motion, slot.posed(), limit, memory);
        });
    });
    return first.answer(w.bodies);
}

std::optional<BodyContact> World::cast(const std::shared_ptr<const Mesh>& mesh, const Pose& pose, const Vec3& motion,
                                       QueryMemory& memory, double time_max,
                                       std::optional<CollisionFilter> filter) const {
    return impl().mesh_shapes.with(
        mesh, [&](const MeshShape& shape) { return cast(shape, pose, motion, memory, time_max, filter); });
}

std::optional<BodyContact> World::cast(BodyId body, const Vec3& motion, double time_max) {
    Impl& w = impl();
    return w.traced<calls::Cast>(cast(body, motion, w.workers.caller_memory(), time_max), body, motion, time_max);
}
std::optional<BodyContact> World::cast(const std::shared_ptr<const Mesh>& mesh, const Pose& pose, const Vec3& motion,
                                       double time_max, std::optional<CollisionFilter> filter) {
    return cast(mesh, pose, motion, impl().workers.caller_memory(), time_max, filter);
}
std::optional<BodyContact> World::cast(const Shape& shape, const Pose& pose, const Vec3& motion, double time_max,
                                       std::optional<CollisionFilter> filter) {
    return cast(shape, pose, motion, impl().workers.caller_memory(), time_max, filter);
}

}  // namespace ecods
