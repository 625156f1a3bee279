// Sorted lists of pairs, changed in place.
#pragma once

#include <vector>

#include "ecods/ids.hpp"

namespace ecods {

using BodyPairs = std::vector<BodyPair>;

// Takes `gone` out of `list`; all ascending, and `gone` is part of `list`. Cost: a search for each, and moving what
// lies behind the first.
void remove_sorted(BodyPairs& list, const BodyPairs& gone) noexcept;

// Puts `more` into `list`; both ascending, without a pair in common. Does not throw when the capacity suffices. Cost as
// above.
void add_sorted(BodyPairs& list, const BodyPairs& more);

// Takes out of both lists, both ascending, what they have in common.
void cancel_common(BodyPairs& first, BodyPairs& second) noexcept;

}  // namespace ecods
