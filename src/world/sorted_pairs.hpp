// Changes sorted lists of pairs in place.
#pragma once

#include <vector>

#include "ecods/ids.hpp"

namespace ecods {

using BodyPairs = std::vector<BodyPair>;

// Removes the pairs `gone` from `list`. Both lists must be ascending, and `list` must contain all of `gone`. Cost: a
// binary search for each pair of `gone`, and moving the elements of `list` behind the first removed pair.
void remove_sorted(BodyPairs& list, const BodyPairs& gone) noexcept;

// Inserts the pairs `more` into `list`. Both lists must be ascending and have no pair in common. Does not throw if the
// capacity of `list` suffices. Cost: a binary search for each pair of `more`, and moving the elements of `list` behind
// it.
void add_sorted(BodyPairs& list, const BodyPairs& more);

// Removes from both lists the pairs that are in both. Both lists must be ascending.
void cancel_common(BodyPairs& first, BodyPairs& second) noexcept;

}  // namespace ecods
