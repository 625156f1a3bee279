#include "query/intersection/asking.hpp"
#include "world/world_impl.hpp"

namespace ecods {

std::vector<BodyId> World::overlapping_bodies(const Aabb& box) const {
    const Impl& w = impl();
    std::vector<BodyId> result;
    for (const ProxyIndex proxy : w.broad_phase.find(box)) result.push_back(w.bodies.id_of(proxy));
    return result;
}

std::vector<BodyId> World::intersecting_bodies(const Asked& asked, const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    w.require_tests_for(subject);
    Asking asking(ask);
    std::vector<BodyId> result;
    for (const ProxyIndex proxy : w.broad_phase.find(w.box_of(subject))) {
        if (w.passes_over(subject, proxy)) continue;
        const Slot& slot = w.bodies[proxy];
        const OrderedTest test = w.tests.find(subject.kind(), slot.kind);
        const bool is_intersecting =
            test.ask(subject.posed, slot.posed(), &TwoBodyTest::intersects, Ask(asking.memory()));
        if (is_intersecting) result.push_back(w.bodies.id_of(proxy));
    }
    return result;
}

}  // namespace ecods
