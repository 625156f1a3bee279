// This header declares casts of the surfaces of two bodies: of all triangles of their meshes, whatever forms the shapes
// have.
#pragma once

#include <optional>

#include "ecods/cast.hpp"
#include "ecods/turn.hpp"
#include "query/cast/turn_leg.hpp"

namespace ecods {

struct MeshAtEnds;
struct StraightMove;

// Return the first contact if its real time is at most `latest`, which must be from 0 to 1; otherwise nullopt. The
// result equals the contact that cast() returns, so its rounded time is at most `latest`, too. Cost: a few tenths of a
// microsecond if the bodies stay far apart all the time; the cost of `intersects` if both bodies are at rest. Throw
// InvalidArgument.
std::optional<FirstContact> cast_until(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness);
std::optional<FirstContact> cast_until(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness);
std::optional<FirstContact> cast_until(const StraightMove& a, const StraightMove& b, double latest, QueryMemory& memory,
                                       PairWitness& witness);
std::optional<FirstContact> cast_until(const MeshAtEnds& a, const MeshAtEnds& b, double latest, QueryMemory& memory,
                                       PairWitness& witness);
std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Vec3& motion_of_b, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness);
std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Turning<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness);
std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness);

// Returns the first contact on the way, whose nodes must be valid.
std::optional<WayContact> cast_until(const Way<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
                                     PairWitness& witness);

// Returns the first contact of body a with b while a moves straight from its place at the end of the leg to the pose
// `to`; nullopt if there is none.
std::optional<FirstContact> settle_from(const MeshShape& a, const TurnLeg& leg, const Pose& to,
                                        const Posed<MeshShape>& b, QueryMemory& memory, PairWitness& witness);

// Returns the contact at time 0 of two bodies that share a point at the start. Call this function only if the bodies
// share one. Counts its work as a part of the query that calls it.
FirstContact contact_at_start(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);

}  // namespace ecods
