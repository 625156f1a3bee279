#include <span>
#include <vector>

#include "geometry/find_invalid.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/search_pieces.hpp"
#include "query/cast/turning_question.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

// Returns the first contact on one leg of a turn or of a way; nullopt if there is none up to `latest`. `are_apart` is
// true if the bodies are known to share no point at the beginning of the leg.
std::optional<FirstContact> search_leg(const MeshShape& a, const TurnLeg& leg, const Posed<MeshShape>& b, double latest,
                                       bool are_apart, QueryMemory& memory, PairWitness& witness) {
    using Search = PieceSearch<TurningQuestion>;
    auto& working = QueryMemoryAccess::part<Search::Working>(memory, &QueryMemoryAccess::State::turning);
    working.question.motion().bind(a, leg, b, QueryMemoryAccess::state(memory).counts.casts);
    const Posed<MeshShape> start(a, leg.start);
    Search search(start, b, latest, memory, witness, working);
    if (are_apart) search.begin_apart();
    return search.run();
}

std::optional<FirstContact> search_turn(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                        double latest, QueryMemory& memory, PairWitness& witness) {
    const TurnLeg leg = leg_of(a.pose, a.turn, motion);
    return search_leg(*a.what, leg, b, latest, false, memory, witness);
}

// Returns the first contact on the way, searching the legs in order. Each leg but the first begins at time 1 of the leg
// before, at which the bodies are known to share no point.
std::optional<WayContact> search_way(const Posed<MeshShape>& a, std::span<const WayNode> nodes,
                                     const Posed<MeshShape>& b, QueryMemory& memory, PairWitness& witness) {
    for (std::size_t k = 0; k <= last_leg(nodes); ++k) {
        const TurnLeg leg = leg_of(a.pose, nodes, k);
        const auto contact = search_leg(*a.what, leg, b, 1, k > 0, memory, witness);
        if (contact) return WayContact{k, *contact};
    }
    return std::nullopt;
}

}  // namespace

std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Vec3& motion_of_b, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness) {
    validate_motion(motion_of_b);
    ++QueryMemoryAccess::state(memory).counts.queries;
    const OtherUnits units(a, motion_of_b, b);
    if (!units.are_better()) return search_turn(a, motion_of_b, b, latest, memory, witness);
    return as_part(
        memory, [&] { return search_turn(units.of(a), units.of(motion_of_b), units.of(b), latest, memory, witness); });
}

std::optional<WayContact> cast_until(const Way<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
                                     PairWitness& witness) {
    ++QueryMemoryAccess::state(memory).counts.queries;
    const Posed<MeshShape> start(*a.what, a.pose);
    std::vector<Vec3> pivots;
    for (const WayNode& node : a.nodes) pivots.push_back(node.pivot);
    const OtherUnits units(start, b, pivots);
    if (!units.are_better()) return search_way(start, a.nodes, b, memory, witness);
    std::vector<WayNode> nodes = a.nodes;
    for (WayNode& node : nodes) node.pivot = units.of(node.pivot);
    return as_part(memory, [&] { return search_way(units.of(start), nodes, units.of(b), memory, witness); });
}

}  // namespace ecods
