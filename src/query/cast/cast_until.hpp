// Casts with a limit of time: what the world asks, whose other bodies may be met before.
#pragma once

#include <optional>

#include "ecods/cast.hpp"

namespace ecods {

// The first contact if its real time is at most `latest`, which is from 0 to 1; nothing otherwise. What is given is the
// answer of cast(), whose rounded time is at most `latest` then, too. Throws InvalidMotion.
std::optional<FirstContact> cast_until(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness);

}  // namespace ecods
