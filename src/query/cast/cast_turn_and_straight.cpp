#include "query/cast/cast_until.hpp"
#include "query/cast/one_time_memory.hpp"
#include "query/cast/search_pieces.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

std::optional<FirstContact> search_pieces(const Turning<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                          QueryMemory& memory, PairWitness& witness) {
    using Search = PieceSearch<TurnAndStraightQuestion>;
    Search::Working& working = OneTimeMemory::of(memory).turn_and_straight;
    working.question.motion().bind(a, b, QueryMemoryAccess::state(memory).counts.casts);
    const Posed<MeshShape> start_a(*a.what, a.pose), start_b(*b.what, b.from);
    return Search(start_a, start_b, latest, memory, witness, working).run();
}

}  // namespace

std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness) {
    ++QueryMemoryAccess::state(memory).counts.queries;
    const OtherUnits units(a, b);
    if (!units.are_better()) return search_pieces(a, b, latest, memory, witness);
    const Turning<MeshShape> scaled_a = units.of(a);
    const Moving<MeshShape> scaled_b = units.of(b);
    return as_part(memory, [&] { return search_pieces(scaled_a, scaled_b, latest, memory, witness); });
}

}  // namespace ecods
