#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "geometry/find_invalid.hpp"
#include "query/body/motion_kinds.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/cast/turn_boxes.hpp"
#include "query/cast/way_boxes.hpp"
#include "query/intersection/asking.hpp"
#include "world/enlarged.hpp"
#include "world/least.hpp"
#include "world/rounded_test.hpp"
#include "world/way_box.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Keeps the body that the moving shape meets first, among the bodies offered so far.
class FirstMet {
  public:
    explicit FirstMet(double max_time) : least_(max_time) {}

    // Offers a body: `ask(max_time)` returns the first contact with it up to that time, or nullopt. Returns the upper
    // bound of the times at which later bodies must be met to win.
    template <class Function>
    double take(ProxyIndex proxy, const Function& ask) {
        const auto reach = least_.reach(proxy);
        if (!reach) return least_.bound();
        const std::optional<FirstContact> contact = ask(*reach);
        if (contact && least_.take(proxy, contact->time)) contact_ = *contact;
        return least_.bound();
    }
    // Offers the bodies that the box, translated, may meet, earliest first. `ask(slot, max_time)` is as above.
    template <class World, class Function>
    void visit(const World& world, const Subject& subject, const Aabb& box, const Vec3& motion, const Function& ask) {
        world.broad_phase.visit_along(box, motion, bound(), [&](ProxyIndex proxy) {
            if (world.passes_over(subject, proxy)) return bound();
            return take(proxy, [&](double max_time) { return ask(world.bodies[proxy], max_time); });
        });
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

FirstMet first_met(const Vec3& motion, double max_time) {
    validate_motion(motion);
    return FirstMet(require_time(max_time));
}

// Casts `a`, moved by `motion`, against `b`. If the test takes the two in the other order, moves `b` by -motion
// instead, which gives the same contact.
std::optional<FirstContact> cast_of(const OrderedTest& test, const Posed<Shape>& a, const Vec3& motion,
                                    const Posed<Shape>& b, double max_time, QueryMemory& memory) {
    return in_order(test, test.swapped ? test.test->cast(b, -motion, a, max_time, memory)
                                       : test.test->cast(a, motion, b, max_time, memory));
}

// Casts `a`, in any motion, against `b` at rest, in the order of the test.
std::optional<FirstContact> cast_of(const OrderedTest& test, const Posed<Shape>& a, const Motion& motion,
                                    const Posed<Shape>& b, double max_time, QueryMemory& memory) {
    return in_order(test, test.swapped ? test.test->cast_any_motion(b, Motion(), a, motion, max_time, memory)
                                       : test.test->cast_any_motion(a, motion, b, Motion(), max_time, memory));
}

}  // namespace

std::optional<BodyContact> World::cast(const Asked& asked, const Vec3& motion, double max_time, const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    FirstMet first = first_met(motion, max_time);
    w.require_tests_for(subject, Question::cast);
    Asking asking(ask);
    first.visit(w, subject, w.box_of(subject), motion, [&](const Slot& slot, double limit) {
        const OrderedTest test = w.tests.find(subject.kind(), slot.kind);
        return cast_of(test, subject.posed, motion, slot.posed(), limit, asking.memory());
    });
    const auto found = first.answer(w.bodies);
    const BodyId* const body = std::get_if<BodyId>(&asked.what());
    return body != nullptr && !subject.filter ? w.traced<calls::Cast>(ask, found, *body, motion, max_time) : found;
}

std::optional<BodyContact> World::cast_to_distance(const Asked& asked, const Vec3& motion, double distance,
                                                   double max_time, const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    require_finite_distance(distance);
    FirstMet first = first_met(motion, max_time);
    const auto with_radius = [](const Posed<Shape>& posed) {
        const auto result = core_and_radius(posed);
        if (!result) throw NotSupported(Question::cast, posed.what->kind(), ShapeKind::mesh());
        return *result;
    };
    const CoreAndRadius mover = with_radius(subject.posed);
    for (ProxyIndex proxy = 0; proxy < w.bodies.end(); ++proxy) {
        if (w.bodies[proxy].is_alive() && !w.passes_over(subject, proxy)) with_radius(w.bodies[proxy].posed());
    }
    Asking asking(ask);
    const Aabb box = enlarged(enlarged(w.box_of(subject), distance), distance);  // by the distance on all sides
    first.visit(w, subject, box, motion, [&](const Slot& slot, double limit) {
        return RoundedPair{mover, with_radius(slot.posed())}.cast(motion, distance, limit, asking.memory());
    });
    return first.answer(w.bodies);
}

// Casts against each body once, when the first piece of the way that may meet it is visited; the cast goes on to the
// end of the motion.
std::optional<BodyContact> World::cast(const Asked& asked, const Motion& motion, double max_time,
                                       const Ask& ask) const {
    if (const auto* const by = std::get_if<Translation>(&motion)) return cast(asked, by->by, max_time, ask);
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    validate(motion);
    FirstMet first(require_time(max_time));
    w.require_tests_for(subject, Question::cast_any_motion);
    Asking asking(ask);
    const auto ask_body = [&](ProxyIndex proxy) {
        first.take(proxy, [&](double limit) {
            const Slot& slot = w.bodies[proxy];
            const OrderedTest test = w.tests.find(subject.kind(), slot.kind);
            return cast_of(test, subject.posed, motion, slot.posed(), limit, asking.memory());
        });
    };
    std::vector<ProxyIndex> known, fresh;  // known: bodies already asked, ascending
    const auto search = [&](double from, const Aabb& box, bool may_divide) {
        if (key_of(from) > key_of(first.bound())) return TurnBoxes::Next::stop;
        fresh.clear();
        std::ranges::set_difference(w.broad_phase.find(box), known, std::back_inserter(fresh));
        std::erase_if(fresh, [&](ProxyIndex proxy) { return w.passes_over(subject, proxy); });
        if (may_divide && !fresh.empty()) return TurnBoxes::Next::divide;
        std::ranges::for_each(fresh, ask_body);
        const auto middle = known.insert(known.end(), fresh.begin(), fresh.end());
        std::inplace_merge(known.begin(), middle, known.end());
        return TurnBoxes::Next::go_on;
    };
    const Aabb box = w.box_of(subject);
    if (const auto* const nodes = nodes_of(motion)) {
        const WayBoxes boxes(box, *nodes);
        for (std::size_t leg = 0; leg + 1 < nodes->size(); ++leg) {
            if (search(boxes.before(leg), boxes.of(leg), false) == TurnBoxes::Next::stop) break;
        }
    } else if (!std::holds_alternative<Straight>(motion)) {
        TurnBoxes(box, turn_of(motion)).visit(first.bound(), search);
    } else {
        search(0, box_of_way(*subject.posed.what, subject.posed.pose, box, motion), false);
    }
    const auto found = first.answer(w.bodies);
    const BodyId* const body = std::get_if<BodyId>(&asked.what());
    return body != nullptr && !subject.filter ? w.traced<calls::CastOf>(ask, found, *body, motion, max_time) : found;
}

}  // namespace ecods
