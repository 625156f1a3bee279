// The least of the distances of the pairs of triangles that a search leaves open.
#pragma once

#include <vector>

#include "query/distance/distance_search.hpp"

namespace ecods {

// Brings together the pairs that certainly have the same closest features, and so the same distance: the least pair of
// triangles first. Returns the first of each group, and pairs that are alone, by upper bound.
std::vector<OpenPair>& group_by_features(std::vector<OpenPair>& open);

// The least distance of all open pairs, rounded once. There must be one at least. Leaves the pair that has it in
// `nearest`.
double round_least(DistanceSearch& search, PairWitness& nearest);

// Whether some open pair's distance is at most d, for the real numbers.
bool is_least_within(DistanceSearch& search, double d, PairWitness& nearest);

// All open pairs that have the least distance, for the real numbers; of those with the same features the least.
std::vector<OpenPair>& find_least(DistanceSearch& search);

}  // namespace ecods
