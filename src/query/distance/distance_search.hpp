// The search for the closest triangles of two posed meshes.
#pragma once

#include <cstdint>
#include <vector>

#include "bvh/walks/walk_two.hpp"
#include "query/distance/distance_question.hpp"

namespace ecods {

// What is left of a pair that was apart: no triangle, and an axis (query/intersection). One that was not within a
// distance is asked from its roots on next time, since two triangles would be measured in vain.
inline constexpr PairWitness apart_witness{.a = PairWitness::none, .b = 0};
constexpr bool is_apart(const PairWitness& witness) noexcept {
    return witness.a == PairWitness::none && witness.b != PairWitness::none;
}

using DistanceSieve = SieveOf<DistanceQuestion>;

class DistanceSearch {
  public:
    // Everything that the arguments refer to must outlive the search.
    DistanceSearch(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);
    DistanceSearch(const DistanceSearch&) = delete;
    DistanceSearch& operator=(const DistanceSearch&) = delete;

    // Tries the witness's triangles first, then the trees. What the sieve knows afterwards is in query/search.
    void run(const SearchGoal& goal, const PairWitness& witness);
    // The least distance of all, rounded once, after a search for it; 0 where the bodies share a point.
    double find_distance(const PairWitness& witness);
    // The same of the open pairs, of which there must be one at least, after run().
    double round_least();

    // Calls visit(pair, interval) for every pair of triangles within d, with what contains its distance.
    template <class Visit>
    void visit_within(double d, Visit&& visit);

    DistanceSieve& sieve() noexcept { return working_.sieve; }
    // Counts one exact rounding or comparison.
    TriangleDistances& exact_pair() noexcept { return question_.exact_pair(); }

  private:
    MeshPair bodies_;
    QueryMemory& memory_;
    SearchMemory<DistanceQuestion>& working_;
    DistanceQuestion& question_;
};

template <class Visit>
void DistanceSearch::visit_within(double d, Visit&& visit) {
    QueryMemoryAccess::State& state = QueryMemoryAccess::state(memory_);
    const float limit = question_.limit_above(d);
    alignas(32) LaneBounds bounds;
    const auto bound = [&](const auto& x, const auto& y) {
        ++state.counts.box_tests;
        return question_.find_near(x, y, limit, bounds);
    };
    const auto take = [&](std::uint32_t i, std::uint32_t j) {
        const DistanceInterval interval = question_.enclose({i, j}, d);
        const auto exact = [&] { return exact_pair().compare(i, j, d) <= 0; };
        if (is_within(interval.lower, interval.upper, d, exact)) visit(TrianglePair{i, j}, interval);
        return true;
    };
    walk_two(bodies_.a.tree.boxes, bodies_.b.tree.boxes, state.stack, bound, take);
}

}  // namespace ecods
