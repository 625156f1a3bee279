#include <utility>

#include "world/world_impl.hpp"

namespace ecods {

namespace {

// Writes the call that creates a body with its pose, filter and user data. (Traces that are older than the call
// `create_with` have two or three calls instead.)
void trace_body(TraceWriter& trace, BodyId body, const Slot& slot, std::uint64_t shape_number) noexcept {
    if (slot.filter == CollisionFilter() && slot.user_data == 0) {
        trace.write<calls::Create>(body, shape_number, slot.pose);
    } else {
        trace.write<calls::CreateWith>(body, shape_number, slot.pose, slot.filter, slot.user_data);
    }
}

}  // namespace

void World::Impl::trace_body(ProxyIndex proxy, std::uint64_t shape_number) noexcept {
    ecods::trace_body(*trace, bodies.id_of(proxy), bodies[proxy], shape_number);
}

// Begins the trace with calls that create the current bodies and settings of the world.
void World::trace_to(std::ostream& out, TraceOptions options) {
    Impl& w = impl();
    w.trace.reset();
    auto trace = std::make_unique<TraceWriter>(out, std::move(options));
    const std::vector<BodyId> ids = w.bodies.ids();
    trace->begin(w.broad_phase.kind(), w.bodies.end());
    for (const BodyId body : ids) {
        const Slot& slot = w.bodies[body.slot - 1];
        trace_body(*trace, body, slot, trace->number_of(slot.shape));
    }
    for (const ProxyPair pair : w.bodies.disabled().list()) {
        trace->write<calls::SetPairEnabled>(w.bodies.id_of(pair.a), w.bodies.id_of(pair.b), false);
    }
    if (w.relations.are_wanted()) trace->write<calls::SetRelations>(true);
    if (w.closeness.wanted()) trace->write<calls::SetClearance>(w.closeness.wanted());
    w.trace = std::move(trace);
}

void World::end_trace() {
    const auto trace = std::exchange(impl().trace, nullptr);
    if (!trace) return;
    trace->flush();
    if (trace->has_failed()) throw TraceFailed();
}

}  // namespace ecods
