// Declares casts with a time limit, for a world in which a body may meet other bodies earlier.
#pragma once

#include <optional>

#include "ecods/cast.hpp"

namespace ecods {

// The first contact if its real time is at most `latest`, which is from 0 to 1; otherwise nullopt. The result is that
// of cast(), so its rounded time is at most `latest`, too. Cost: a few tenths of a microsecond if the bodies are far
// apart all the way; the cost of `intersects` if both are at rest. Throws InvalidArgument.
std::optional<FirstContact> cast_until(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness);
std::optional<FirstContact> cast_until(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness);

// The contact, at time 0, of bodies that share a point before they move, which is required. Counts as part of another
// query.
FirstContact contact_at_start(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);

}  // namespace ecods
