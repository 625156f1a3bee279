// The first contact of bodies on their way between poses, with a limit.
#pragma once

#include <optional>

#include "ecods/cast.hpp"

namespace ecods {

// As cast, but nothing where the first contact, rounded, is after `at_most`, which is from 0 to 1. Bodies that are far
// apart all the way cost a few tenths of a microsecond, and two at rest no more than `intersects`.
std::optional<FirstContact> cast_until(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double at_most,
                                       QueryMemory& memory, PairWitness& witness);

}  // namespace ecods
