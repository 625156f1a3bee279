// Searches for the body that a moving subject meets, or enters, first.
#pragma once

#include <optional>

#include "base/limits.hpp"
#include "geometry/find_invalid.hpp"
#include "world/least.hpp"
#include "world/world_impl.hpp"

namespace ecods {

// FirstMet keeps the body of the least time among the bodies offered so far. Found is the answer: a body and an Event,
// which has a time.
template <class Found, class Event>
class FirstMet {
  public:
    explicit FirstMet(double max_time) : least_(max_time) {}

    // Replaces the best body so far by this body if its first event is earlier, or ties and has the lesser proxy.
    // `ask(max_time)` returns the first event with the body up to max_time; if there is none, nullopt or a later event.
    // Returns an upper bound of the times with which bodies offered later may win.
    template <class Function>
    double take(ProxyIndex proxy, const Function& ask) {
        const auto reach = least_.reach(proxy);
        if (!reach) return least_.bound();
        const std::optional<Event> event = ask(*reach);
        if (event && least_.take(proxy, event->time)) event_ = *event;
        return least_.bound();
    }
    // Calls take() for the bodies that `box`, translated by `motion`, may meet, earliest first, except the bodies that
    // a question about the subject skips. `ask(slot, max_time)` returns the event with the body in the slot, as for
    // take().
    template <class World, class Function>
    void visit(const World& world, const Subject& subject, const Aabb& box, const Vec3& motion, const Function& ask) {
        world.broad_phase.visit_along(box, motion, bound(), [&](ProxyIndex proxy) {
            if (world.passes_over(subject, proxy)) return bound();
            return take(proxy, [&](double max_time) { return ask(world.bodies[proxy], max_time); });
        });
    }
    double bound() const noexcept { return least_.bound(); }
    std::optional<Found> answer(const Bodies& bodies) const {
        if (!least_.has_name()) return std::nullopt;
        return Found{bodies.id_of(least_.name()), event_};
    }

  private:
    Least<ProxyIndex> least_;
    Event event_;
};
using FirstBodyMet = FirstMet<BodyContact, FirstContact>;
using FirstBodyEntered = FirstMet<BodyEntry, FirstEntry>;

// Returns a new search for a subject that is translated by `motion` up to max_time. Throws InvalidArgument if the
// motion is not finite, or the time is negative or NaN.
template <class Search>
Search search_along(const Vec3& motion, double max_time) {
    validate_motion(motion);
    return Search(require_time(max_time));
}

}  // namespace ecods
