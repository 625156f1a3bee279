#include "geometry/find_invalid.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/search_pieces.hpp"
#include "query/cast/turning_question.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

std::optional<FirstContact> search_pieces(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                          double latest, QueryMemory& memory, PairWitness& witness) {
    using Search = PieceSearch<TurningQuestion>;
    auto& working = QueryMemoryAccess::part<Search::Working>(memory, &QueryMemoryAccess::State::turning);
    working.question.motion().bind(a, motion, b, QueryMemoryAccess::state(memory).counts.casts);
    const Posed<MeshShape> start(*a.what, a.pose);
    return Search(start, b, latest, memory, witness, working).run();
}

}  // namespace

std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Vec3& motion_of_b, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness) {
    validate_motion(motion_of_b);
    ++QueryMemoryAccess::state(memory).counts.queries;
    const OtherUnits units(a, motion_of_b, b);
    if (!units.are_better()) return search_pieces(a, motion_of_b, b, latest, memory, witness);
    const Turning<MeshShape> scaled_a = units.of(a);
    const Posed<MeshShape> scaled_b = units.of(b);
    const Vec3 motion = units.of(motion_of_b);
    return as_part(memory, [&] { return search_pieces(scaled_a, motion, scaled_b, latest, memory, witness); });
}

}  // namespace ecods
