// Casts find when a moving body first shares a point with another body (FCL: continuousCollide; Parry: cast_shapes;
// Box3D: time of impact). No World is needed.
//
//     std::optional<FirstContact> contact = cast({cube, pose_a}, motion, {cube, pose_b});
//     if (contact) contact->time, contact->a, contact->b
//
// There are two kinds of motion, in the time from 0 to 1. Translation by m: at time s a body is at the real points R v
// + t + s m. Straight motion between two poses: each point moves from R0 v + t0 to R1 v + t1 on a straight line, at
// constant speed, so at time s the pose's entries are (1 - s) (R0, t0) + s (R1, t1), as real numbers. This is no
// rotation: halfway through half a turn the body is flat. Split a long turn into short moves.
//
// Contact is decided for the real numbers: contact at time 0 and at the last time counts, and so does grazing. The time
// is the least real time, rounded once (distance.hpp says how); a positive time is at least 2^-1074. So the time is 0
// exactly if the bodies share a point at the start. Equal input gives equal bits, in any rounding mode.
//
// Everything is defined for all finite poses and motions and for zero-area triangles, also for bodies that become flat
// while they move. Bodies and threads are as in intersection.hpp.
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

// Bodies are as in intersection.hpp. If a part of one is inside the other at the start, the first contact is at time 0.

// Returns the first contact of a, translated by time times `motion`, with b, which stays; nullopt if there is none up
// to max_time, in real time. Starts from a witness, and leaves the triangles that decided. Throws InvalidArgument if a
// coordinate of the motion is not finite, or max_time is negative or NaN. A max_time above 1 counts as 1. Cost: a walk
// of both trees, earliest boxes first. A pair of triangles that is a candidate costs some tenths of a microsecond; the
// last one or few, which are compared exactly, about one microsecond. If faces meet face on, all pairs that touch first
// are compared exactly, at some microseconds each. A short motion costs about as much as the distance at its end.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion,
                                                         const Posed<MeshShape>& b, double max_time = 1,
                                                         const Ask& ask = {});

// Returns the first contact of two bodies that each move from one pose to another; nullopt if there is none up to
// max_time. Cost: as above, and a few times as much. The exact decision of two triangles, usually one in a cast, takes
// some tens of microseconds; for triangles that graze each other a tenth of a millisecond; and if some numbers are
// 2^600 times as large as others, tens of milliseconds.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});

}  // namespace ecods
