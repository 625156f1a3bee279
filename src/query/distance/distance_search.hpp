// Searches for the closest triangles of two posed meshes.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "bvh/walks/walk_two.hpp"
#include "geometry/feature_key.hpp"
#include "query/distance/distance_question.hpp"

namespace ecods {

// apart_witness is the witness of a pair that was not within a distance. It names no triangle, and its `b` is the
// number of an axis (query/intersection). The next query of the pair begins at the roots, because trying two triangles
// first would be in vain.
inline constexpr PairWitness apart_witness{.a = PairWitness::none, .b = 0};
constexpr bool is_apart(const PairWitness& witness) noexcept {
    return witness.a == PairWitness::none && witness.b != PairWitness::none;
}

using DistanceSieve = SieveOf<DistanceQuestion>;

// Calls closest(pair) for all open pairs, which have the same distance, and returns the result that is first by the
// rule of ClosestPoints. There must be an open pair.
template <class Closest>
ClosestPoints least_closest(const std::vector<DistanceSieve::Open>& open, Closest&& closest) {
    ClosestPoints result = closest(open[0].triangles);
    for (std::size_t i = 1; i < open.size(); ++i) {
        const ClosestPoints other = closest(open[i].triangles);
        if (rank(other) < rank(result)) result = other;
    }
    return result;
}

class DistanceSearch {
  public:
    // Everything that the arguments refer to must outlive the search.
    DistanceSearch(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);
    DistanceSearch(const DistanceSearch&) = delete;
    DistanceSearch& operator=(const DistanceSearch&) = delete;

    // Tries the witness's triangles first, then searches the trees. Afterwards sieve() holds the result (query/search).
    void run(const SearchGoal& goal, const PairWitness& witness);
    // Searches for the least distance, and returns it rounded once; returns 0 if the bodies share a point.
    double find_distance(const PairWitness& witness);
    // Returns the least distance of the open pairs, rounded once. Call it after run(), and only if a pair is open.
    double round_least();

    // Calls visit(pair, interval) for every pair of triangles within d; `interval` contains the pair's distance.
    // `visit` may return a bool: false ends the walk.
    template <class Visit>
    void visit_within(double d, Visit&& visit);

    DistanceSieve& sieve() noexcept { return working_.sieve; }
    // Counts one exact operation, and returns the object that performs it. Call it once for each rounding or
    // comparison.
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
        if (!is_within(interval.lower, interval.upper, d, exact)) return true;
        if constexpr (std::is_same_v<decltype(visit(TrianglePair{i, j}, interval)), bool>) {
            return visit(TrianglePair{i, j}, interval);
        } else {
            visit(TrianglePair{i, j}, interval);
            return true;
        }
    };
    walk_two(bodies_.a.tree.boxes, bodies_.b.tree.boxes, state.stack, bound, take);
}

}  // namespace ecods
