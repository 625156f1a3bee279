#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "query/body/motion_kinds.hpp"
#include "query/cast/turn_boxes.hpp"
#include "query/cast/way_boxes.hpp"
#include "query/intersection/asking.hpp"
#include "world/enlarged.hpp"
#include "world/first_met.hpp"
#include "world/rounded_test.hpp"
#include "world/straight_moves.hpp"
#include "world/way_box.hpp"

namespace ecods {
namespace {

// Returns the first contact of `a`, which is translated by `motion`, and `b` at rest. If the test takes the two in the
// other order, moves `b` by -motion instead, which gives the same contact.
std::optional<FirstContact> cast_of(const OrderedTest& test, const Posed<Shape>& a, const Vec3& motion,
                                    const Posed<Shape>& b, double max_time, QueryMemory& memory) {
    return in_order(test, test.swapped ? test.test->cast(b, -motion, a, max_time, memory)
                                       : test.test->cast(a, motion, b, max_time, memory));
}

// Returns the first contact of `a`, which moves by `motion`, and `b` at rest. The test gets the two bodies in the order
// of its kinds.
std::optional<FirstContact> cast_of(const OrderedTest& test, const Posed<Shape>& a, const Motion& motion,
                                    const Posed<Shape>& b, double max_time, QueryMemory& memory) {
    if (const auto* const straight = std::get_if<Straight>(&motion)) {
        const Moving<Shape> moved(*a.what, a.pose, straight->to), rest(*b.what, b.pose, b.pose);
        return in_order(test, test.swapped ? test.test->cast_moving(rest, moved, max_time, memory)
                                           : test.test->cast_moving(moved, rest, max_time, memory));
    }
    return in_order(test, test.swapped ? test.test->cast_any_motion(b, Motion(), a, motion, max_time, memory)
                                       : test.test->cast_any_motion(a, motion, b, Motion(), max_time, memory));
}

// Throws NotSupported if the subject has no cast of its move with some body, as rounded bodies may not have.
void require_straight_cast(const Subject& subject, const Pose& end, const Bodies& bodies, const TwoBodyTests& tests) {
    if (!is_rounded(subject.kind()) && !bodies.has_rounded()) return;
    StraightMoves moves;
    moves.add(subject.posed, &end);
    if (!moves.has_turning()) return;
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        if (bodies[proxy].is_alive() && proxy != subject.proxy) moves.add(bodies[proxy].posed(), nullptr);
    }
    moves.require_casts(tests);
}

}  // namespace

std::optional<BodyContact> World::cast(const Asked& asked, const Vec3& motion, double max_time, const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    auto first = search_along<FirstBodyMet>(motion, max_time);
    w.require_tests_for(subject, Question::cast);
    Asking asking(ask);
    first.visit(w, subject, w.box_of(subject), motion, [&](const Slot& slot, double limit) {
        const OrderedTest test = w.tests.find(subject.kind(), slot.kind);
        return cast_of(test, subject.posed, motion, slot.posed(), limit, asking.memory());
    });
    return w.traced_of<calls::Cast>(ask, first.answer(w.bodies), asked, motion, max_time);
}

std::optional<BodyContact> World::cast_to_distance(const Asked& asked, const Vec3& motion, double distance,
                                                   double max_time, const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    require_finite_distance(distance);
    auto first = search_along<FirstBodyMet>(motion, max_time);
    const CoreAndRadius mover = require_core(subject.posed);
    const auto have_radii = [](ShapeKind kind) { return kind == ShapeKind::mesh() || is_rounded(kind); };
    if (!w.bodies.have_kinds(have_radii)) {
        w.for_each_asked(subject, [](const Slot& slot) { require_core(slot.posed()); });
    }
    Asking asking(ask);
    const Aabb box = enlarged(enlarged(w.box_of(subject), distance), distance);  // by the distance on all sides
    first.visit(w, subject, box, motion, [&](const Slot& slot, double limit) {
        return RoundedPair{mover, require_core(slot.posed())}.cast(motion, distance, limit, asking.memory());
    });
    return w.traced_of<calls::CastToDistance>(ask, first.answer(w.bodies), asked, motion, distance, max_time);
}

// Casts the subject against each body once, when the search visits the first piece of the way that may meet the body.
// The cast is not limited to that piece.
std::optional<BodyContact> World::cast(const Asked& asked, const Motion& motion, double max_time,
                                       const Ask& ask) const {
    if (const auto* const by = std::get_if<Translation>(&motion)) return cast(asked, by->by, max_time, ask);
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    validate(motion);
    FirstBodyMet first(require_time(max_time));
    const auto* const straight = std::get_if<Straight>(&motion);
    w.require_tests_for(subject, straight != nullptr ? Question::cast_moving : Question::cast_any_motion);
    if (straight != nullptr) require_straight_cast(subject, straight->to, w.bodies, w.tests);
    Asking asking(ask);
    const auto ask_body = [&](ProxyIndex proxy) {
        first.take(proxy, [&](double limit) {
            const Slot& slot = w.bodies[proxy];
            const OrderedTest test = w.tests.find(subject.kind(), slot.kind);
            return cast_of(test, subject.posed, motion, slot.posed(), limit, asking.memory());
        });
    };
    std::vector<ProxyIndex> known, fresh;  // known: bodies already tested, ascending
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
    return w.traced_of<calls::CastOf>(ask, first.answer(w.bodies), asked, motion, max_time);
}

}  // namespace ecods
