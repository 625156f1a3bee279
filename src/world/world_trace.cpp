#include <utility>

#include "world/world_impl.hpp"

namespace ecods {

// What is here is written as the calls that make it.
void World::trace_to(std::ostream& out, TraceOptions options) {
    Impl& w = *impl_;
    w.trace.reset();
    auto trace = std::make_unique<TraceWriter>(out, std::move(options));
    const auto bodies = this->bodies();
    trace->begin(w.broad_phase->kind(), w.slots.size());
    for (const BodyId body : bodies) {
        const Slot& slot = w.slots[body.slot - 1];
        trace->write<calls::Create>(body, trace->number_of(slot.shape), slot.pose);
        if (slot.filter != CollisionFilter()) trace->write<calls::SetFilter>(body, slot.filter);
        if (slot.user_data != 0) trace->write<calls::SetUserData>(body, slot.user_data);
    }
    for (const ProxyPair pair : w.disabled.list()) {
        trace->write<calls::SetPairEnabled>(w.id_of(pair.a), w.id_of(pair.b), false);
    }
    w.trace = std::move(trace);
}

void World::end_trace() {
    const auto trace = std::exchange(impl_->trace, nullptr);
    if (!trace) return;
    trace->flush();
    if (trace->has_failed()) throw TraceFailed();
}

}  // namespace ecods
