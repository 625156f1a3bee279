#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "geometry/same_bits.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/moving_question.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

// True if the body does not move. Compares bits, because a processor that flushes subnormal numbers compares two
// different ones as equal.
bool is_at_rest(const Moving<MeshShape>& body) {
    return same_bits(body.from, body.to);
}

}  // namespace

std::optional<FirstContact> cast_until(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness) {
    using Working = SearchMemory<MovingQuestion>;
    Working& working = QueryMemoryAccess::part<Working>(memory, &QueryMemoryAccess::State::moving);
    MovingQuestion& question = working.question;
    QueryCounts& counts = QueryMemoryAccess::state(memory).counts;
    ++counts.queries;
    StraightMotion& motion = question.motion();
    motion.bind_boxes(a, b);
    const std::optional<float> first = motion.first_of_boxes();
    if (!first) return std::nullopt;
    const OtherUnits units(a, b);
    if (units.are_better()) {
        return as_part(memory, [&] { return cast_until(units.of(a), units.of(b), latest, memory, witness); });
    }
    PairWitness at_start = witness;
    const Posed<MeshShape> start_a(*a.what, a.from), start_b(*b.what, b.from);
    if (!(*first > 0) && as_part(memory, [&] { return surface::intersects(start_a, start_b, {memory, at_start}); })) {
        witness = at_start;
        return contact_at_start(start_a, start_b, memory);
    }
    if (is_at_rest(a) && is_at_rest(b)) return std::nullopt;
    motion.bind(a, b, counts.casts);
    question.start(latest);
    const MeshPair bodies{MeshBody(start_a), MeshBody(start_b)};
    Search(bodies, working, memory).run({.at_most = latest}, bodies.named_by(witness));
    const auto contact = first_contact(working.sieve, [](const auto&) { return std::optional<FirstContact>(); });
    const bool may_be_late = contact && key_of(contact->time) == key_of(latest) && key_of(latest) < key_of(1.0);
    if (!contact || (may_be_late && !question.is_by_then())) return std::nullopt;
    witness = {contact->a.triangle, contact->b.triangle};
    return contact;
}

}  // namespace ecods
