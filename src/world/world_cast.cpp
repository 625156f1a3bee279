#include <utility>
#include <variant>

#include "base/limits.hpp"
#include "geometry/find_invalid.hpp"
#include "query/intersection/asking.hpp"
#include "world/least.hpp"
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
    if (!test.swapped) return test.test->cast(a, motion, b, max_time, memory);
    auto contact = test.test->cast(b, -motion, a, max_time, memory);
    if (contact) std::swap(contact->a, contact->b);
    return contact;
}

}  // namespace

std::optional<BodyContact> World::cast(const Asked& asked, const Vec3& motion, double max_time, const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    FirstMet first = first_met(motion, max_time);
    w.require_tests_for(subject, Question::cast);
    Asking asking(ask);
    w.broad_phase.visit_along(w.box_of(subject), motion, first.bound(), [&](ProxyIndex proxy) {
        if (w.passes_over(subject, proxy)) return first.bound();
        const Slot& slot = w.bodies[proxy];
        return first.take(proxy, [&](double limit) {
            const OrderedTest test = w.tests.find(subject.kind(), slot.kind);
            return cast_of(test, subject.posed, motion, slot.posed(), limit, asking.memory());
        });
    });
    const auto found = first.answer(w.bodies);
    const BodyId* const body = std::get_if<BodyId>(&asked.what());
    return body != nullptr && !subject.filter ? w.traced<calls::Cast>(ask, found, *body, motion, max_time) : found;
}

}  // namespace ecods
