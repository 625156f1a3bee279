// When does a body that moves first share a point with another one? No World is needed.
//
// Two motions, both with time from 0 to 1. A translation: at time s a body is at the real points R v + t + s m. A
// straight motion from one pose to another: each point goes from R0 v + t0 to R1 v + t1 on a straight line, at constant
// speed; so at time s the pose's entries are (1 - s) (R0, t0) + s (R1, t1), as real numbers. That is no rotation in
// between: of half a turn the middle is flat. Make several short moves of one long turn.
//
// Whether there is contact is decided for the real numbers: contact at time 0 and at 1 counts, and so does grazing. The
// time is the least real one, rounded once (distance.hpp says how); positive times are at least 2^-1074, so that a time
// is 0 exactly when the bodies share a point at the start. Equal input gives equal bits, in any rounding mode.
//
// Everything is defined for all finite poses and motions and for zero-area triangles, also for bodies that become flat
// on the way. Poses must be finite (validate(Pose)); a query does not check them.
//
// Thread safety: as in intersection.hpp.
#pragma once

#include <optional>

#include "ecods/export.hpp"
#include "ecods/first_contact.hpp"
#include "ecods/intersection.hpp"
#include "ecods/motion.hpp"

namespace ecods {

// The first contact of a, which is translated by time times `motion`, with b, which stays; nothing if there is none up
// to time 1. Throws InvalidArgument if a coordinate of the motion is not finite.
// Cost: a walk of both trees, earliest boxes first; a pair of triangles that is a candidate costs some tenths of a
// microsecond, and the last one or few, which are compared exactly, about one. Where faces meet face on, those are all
// pairs that touch first, at some microseconds each. On a short way it costs about as much as the distance at its end.
ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                           QueryMemory& memory);

// The same, for a pair that was asked about before and has moved little: tries the witness's triangles first, and
// leaves those that decided. The witness may come from any question and any bodies.
ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                           QueryMemory& memory, PairWitness& witness);

// The first contact of two bodies of which each goes from one pose to another; nothing if there is none up to time 1.
// Cost: as above, and a few times as much. The exact decision of two triangles, mostly one in a cast, takes some tens
// of microseconds; of such as graze each other a tenth of a millisecond, and with numbers of which some are 2^600 times
// as large as others tens of milliseconds.
ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<MeshShape>& b, QueryMemory& memory);
ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<MeshShape>& b, QueryMemory& memory,
                                           PairWitness& witness);

}  // namespace ecods
