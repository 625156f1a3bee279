#include <algorithm>
#include <limits>
#include <variant>

#include "base/limits.hpp"
#include "query/intersection/asking.hpp"
#include "world/least.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

template <class Name>
Least<Name> least_within(double limit) {
    require_distance(limit);
    return Least<Name>(limit);
}

// Makes `name` the candidate of `least` if its distance is the least so far. Calls distance() only if within(limit) is
// true for the greatest distance with which the candidate can win. Returns an upper bound of the distances with which
// later candidates can win.
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

std::optional<NearestBody> World::nearest(const Asked& asked, double max_distance, const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    auto least = least_within<ProxyIndex>(max_distance);
    w.require_tests_for(subject, Question::within);
    w.require_tests_for(subject, Question::distance);
    Asking asking(ask);
    w.broad_phase.visit_near(w.box_of(subject), max_distance, [&](ProxyIndex proxy) {
        if (w.passes_over(subject, proxy)) return least.bound();
        const Slot& slot = w.bodies[proxy];
        const OrderedTest test = w.tests.find(subject.kind(), slot.kind);
        const Posed<Shape> other = slot.posed();
        const Ask in_memory(asking.memory());
        return take(
            least, proxy, [&](double d) { return test.ask(subject.posed, other, &TwoBodyTest::within, d, in_memory); },
            [&] { return test.ask(subject.posed, other, &TwoBodyTest::distance, in_memory); });
    });
    return w.traced_of<calls::Nearest>(ask, nearest_of(least, w.bodies), asked, max_distance);
}

}  // namespace ecods
