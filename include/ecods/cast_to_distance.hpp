// cast_to_distance() finds when a translated body is first within a distance of another one. (Parry: target_distance of
// cast_shapes; Box2D: a time of impact with a target.) No World is needed.
//
//     if (auto contact = cast_to_distance({drone, pose_a}, motion, {house, pose_b}, 0.5)) contact->time
//
// The time is the least real time from 0 on at which the distance of the bodies is at most `distance`, decided for real
// numbers and rounded once (distance.hpp says how): a body that comes to exactly that distance, or passes at it, is
// found. A positive time is at least 2^-1074, so the time is 0 exactly if the bodies are within the distance at the
// start. Bodies that share a point, and a body inside a solid, have the distance 0. With the distance 0, the answer is
// that of cast().
//
// Kind and features are those of the closest points at the time, by the rule of FirstContact: they name where the
// bodies are closest. At time 0 they are those of closest(). Of rounded bodies they are those of the cores.
//
// Everything is defined for all finite poses and motions and for zero-area triangles. Bodies and threads are as in
// intersection.hpp. Only translations are answered: there is no cast_to_distance of a straight motion between two poses
// or of a turn. World::cast_to_distance() asks about all bodies of a World.
//
// Method: the question is a cast of rounded bodies whose radii add up to the distance (rounded.hpp).
//
// Example: verify/examples/how_do_i, stop_at_a_distance().
#pragma once

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/rounded.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Return when a, translated by time times `motion`, is first within `distance` of b, which stays; nullopt if it is not
// up to max_time, in real time. Of rounded bodies it is the distance of their surfaces: the radii and `distance` are
// added exactly. Start from a witness. Throw InvalidArgument if the distance is negative, NaN or infinite, a coordinate
// of the motion is not finite, or max_time is negative or NaN. A max_time above 1 counts as 1. Cost: that of a cast of
// rounded bodies; with the distance 0 and no radii, that of cast().
[[nodiscard]] ECODS_API std::optional<FirstContact> cast_to_distance(const Posed<MeshShape>& a, const Vec3& motion,
                                                                     const Posed<MeshShape>& b, double distance,
                                                                     double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast_to_distance(const Posed<Rounded>& a, const Vec3& motion,
                                                                     const Posed<Rounded>& b, double distance,
                                                                     double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast_to_distance(const Posed<Rounded>& a, const Vec3& motion,
                                                                     const Posed<MeshShape>& b, double distance,
                                                                     double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast_to_distance(const Posed<MeshShape>& a, const Vec3& motion,
                                                                     const Posed<Rounded>& b, double distance,
                                                                     double max_time = 1, const Ask& ask = {});

}  // namespace ecods
