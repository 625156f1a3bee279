// Changes sorted lists of pairs in place.
#pragma once

#include <vector>

#include "ecods/ids.hpp"

namespace ecods {

using BodyPairs = std::vector<BodyPair>;

// Removes the pairs `gone` from `list`. Both are ascending, and `list` contains all of `gone`. Cost: a binary search
// for each pair, and moving the elements behind the first one.
void remove_sorted(BodyPairs& list, const BodyPairs& gone) noexcept;

// Inserts the pairs `more` into `list`. Both are ascending and have no pair in common. Does not throw if the capacity
// suffices. Cost: as for remove_sorted().
void add_sorted(BodyPairs& list, const BodyPairs& more);

// Removes the pairs that both lists contain from both. Both are ascending.
void cancel_common(BodyPairs& first, BodyPairs& second) noexcept;

}  // namespace ecods
