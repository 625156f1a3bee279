// Casts with a limit of time: what the world asks, whose other bodies may be met before.
#pragma once

#include <optional>

#include "ecods/cast.hpp"

namespace ecods {

// The first contact if its real time is at most `latest`, which is from 0 to 1; nothing otherwise. What is given is the
// answer of cast(), whose rounded time is at most `latest` then, too. Bodies that are far apart all the way cost a few
// tenths of a microsecond, and two at rest no more than `intersects`. Throws InvalidArgument.
std::optional<FirstContact> cast_until(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness);
std::optional<FirstContact> cast_until(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness);

// The contact of bodies that share a point before they move, which they must. Part of another question.
FirstContact contact_at_start(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);

}  // namespace ecods
