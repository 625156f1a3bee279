// The first contact of bodies on their way between poses, with a limit.
#pragma once

#include <optional>

#include "ecods/cast.hpp"

namespace ecods {

// The first contact if its real time is at most `at_most`, which is from 0 to 1; nothing otherwise. What is given is
// the answer of cast(), whose rounded time is at most `at_most` then, too. Bodies that are far apart all the way cost a
// few tenths of a microsecond, and two at rest no more than `intersects`.
std::optional<FirstContact> cast_until(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double at_most,
                                       QueryMemory& memory, PairWitness& witness);

}  // namespace ecods
