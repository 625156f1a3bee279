// Casts find when a body on the move first shares a point with another one (FCL: continuousCollide; Parry: cast_shapes;
// Box3D: time of impact). No World is needed.
//
//     std::optional<FirstContact> contact = cast({cube, pose_a}, motion, {cube, pose_b});
//     if (contact) contact->time, contact->a, contact->b
//
// Two motions, both with time from 0 to 1. A translation: at time s a body is at the real points R v + t + s m. A
// straight motion from one pose to another: each point goes from R0 v + t0 to R1 v + t1 on a straight line, at constant
// speed; so at time s the pose's entries are (1 - s) (R0, t0) + s (R1, t1), as real numbers. That is no rotation:
// halfway through half a turn the body is flat. Split a long turn into short moves.
//
// Contact is decided for the real numbers: contact at time 0 and at the last time counts, and so does grazing. The time
// is the least real one, rounded once (distance.hpp says how); positive times are at least 2^-1074, so that a time is 0
// exactly when the bodies share a point at the start. Equal input gives equal bits, in any rounding mode.
//
// Everything is defined for all finite poses and motions and for zero-area triangles, also for bodies that become flat
// on the way. Bodies and threads are as in intersection.hpp.
//
// Example: verify/examples/how_do_i, cast_on_its_way().
#pragma once

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns the first contact of a, which is translated by time times `motion`, with b, which stays; empty if there is
// none up to max_time, decided for the real time. Starts from a witness, and leaves the triangles that decided. Throws
// InvalidArgument if a coordinate of the motion is not finite, or max_time is negative or NaN; above 1 it is as 1.
// Cost: a walk of both trees, earliest boxes first; a pair of triangles that is a candidate costs some tenths of a
// microsecond, and the last one or few, which are compared exactly, about one. Where faces meet face on, all pairs that
// touch first are compared exactly, at some microseconds each. On a short way it costs about as much as the distance at
// its end.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion,
                                                         const Posed<MeshShape>& b, double max_time = 1,
                                                         const Ask& ask = {});

// Returns the first contact of two bodies that each go from one pose to another; empty if there is none up to max_time.
// Cost: as above, and a few times as much. The exact decision of two triangles, mostly one in a cast, takes some tens
// of microseconds; of triangles that graze each other a tenth of a millisecond, and with numbers of which some are
// 2^600 times as large as others tens of milliseconds.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});

}  // namespace ecods
