// Other ways to write a pair of posed triangles that leave the answer as it is.
//
// Each changes the numbers exactly or not at all: a way that would round, overflow or underflow returns false and
// leaves the pair alone.
#pragma once

#include <span>

#include "scenes/hard_pairs.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

struct Variant {
    const char* name;
    bool (*apply)(scenes::PosedPair& pair, scenes::Random& random);
};

// corners in another order; times a power of two; one of the 48 axis symmetries on space; each body modelled in another
// frame (a signed permutation of its axes, each times a power of two); a regular affine map of small integers on space.
std::span<const Variant> variants();

// One of them: the bodies' poses are then no longer the same bits, though the points are the same.
bool model_in_other_frames(scenes::PosedPair& pair, scenes::Random& random);

}  // namespace ecods::fuzz
