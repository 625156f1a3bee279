#include "query/distance/distance_search.hpp"

#include <functional>
#include <optional>

#include "base/assert.hpp"
#include "base/double_key.hpp"

namespace ecods {

DistanceSearch::DistanceSearch(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory)
    : bodies_{MeshBody(a), MeshBody(b)},
      memory_(memory),
      working_(QueryMemoryAccess::part<SearchMemory<DistanceQuestion>>(memory, &QueryMemoryAccess::State::distance)),
      question_(working_.question) {
    QueryCounts& counts = QueryMemoryAccess::state(memory).counts;
    ++counts.queries;
    question_.bind(bodies_, counts);
}

void DistanceSearch::run(const SearchGoal& goal, const PairWitness& witness) {
    std::optional<TrianglePair> first = bodies_.named_by(witness);
    if (!first && !question_.is_far() && (goal.stop_at < 0 || !is_apart(witness))) first = question_.dive(bodies_);
    Search(bodies_, working_, memory_).run(goal, first);
}

double DistanceSearch::find_distance(const PairWitness& witness) {
    question_.exclude();
    run({}, witness);
    return sieve().is_zero() ? 0 : round_least();
}

double DistanceSearch::round_least() {
    const auto round = [&](const DistanceSieve::Open& open,
                           const std::optional<double>& least) -> std::optional<double> {
        if (least) {
            if (key_of(open.interval.lower) >= key_of(*least) || question_.is_not_less(open.triangles)) return {};
        }
        const double distance = exact_pair().distance(open.triangles.a, open.triangles.b);
        if (!least || key_of(distance) < key_of(*least)) question_.refer_to(open.triangles);
        return distance;
    };
    const std::optional<double> least = sieve().least(round, std::identity(), [](double) { return 0; });
    ECODS_ASSERT(least);
    return *least;
}

}  // namespace ecods
