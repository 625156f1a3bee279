#include "query/cast/cast_moving.hpp"

#include "geometry/same_bits.hpp"
#include "query/cast/contact_at_start.hpp"
#include "query/cast/moving_search.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

// By bits: where subnormal numbers count as zero, numbers that differ may compare equal.
bool is_at_rest(const Moving<MeshShape>& body) {
    return same_bits(body.from, body.to);
}

}  // namespace

std::optional<FirstContact> cast_until(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double at_most,
                                       QueryMemory& memory, PairWitness& witness) {
    MovingSearch search(a, b, memory);
    const std::optional<float> first = search.first_of_boxes();
    if (!first) return std::nullopt;
    const OtherUnits units(a, b);
    if (units.are_better()) {
        return as_part(memory, [&] { return cast_until(units.of(a), units.of(b), at_most, memory, witness); });
    }
    PairWitness at_start = witness;
    if (!(*first > 0)) {
        const Posed<MeshShape> start_a(*a.what, a.from), start_b(*b.what, b.from);
        if (as_part(memory, [&] { return intersects(start_a, start_b, memory, at_start); })) {
            witness = at_start;
            return contact_at_start(start_a, start_b, memory);
        }
    }
    if (is_at_rest(a) && is_at_rest(b)) return std::nullopt;
    const std::optional<FirstContact> contact = search.run(at_most, witness);
    if (contact) witness = {contact->a.triangle, contact->b.triangle};
    return contact;
}

std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<MeshShape>& b, QueryMemory& memory,
                                 PairWitness& witness) {
    return cast_until(a, b, 1, memory, witness);
}

std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<MeshShape>& b, QueryMemory& memory) {
    PairWitness witness;
    return cast_until(a, b, 1, memory, witness);
}

}  // namespace ecods
