// Answers about bodies that turn from node to node (include/ecods/turn.hpp), about where bodies touch first, and about
// the gap between the end of a turn and a pose, judged by the oracle.
#pragma once

#include <optional>

#include "ecods/contact.hpp"
#include "ecods/turn.hpp"
#include "judge/wrong.hpp"
#include "oracle/way.hpp"

namespace ecods::judge {

// The way as the oracle takes it.
oracle::WaySoup way_soup(const Way<MeshShape>& a);

// The first contact along the way, with its point and normal.
std::optional<Wrong> ask_about_way(const Way<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);

// All of it about a turn: as a way of two nodes, and along one that goes through `between`, a place of quaternion and
// pivot. The turn's own contact and its point are those of the way of two nodes, bit for bit.
std::optional<Wrong> ask_about_turn_as_way(const Turning<MeshShape>& a, const WayNode& between,
                                           const Posed<MeshShape>& b, const Ask& ask);

// The point and the normal of the first contact on a straight motion, if there is one.
std::optional<Wrong> ask_about_point(const Moving<MeshShape>& a, const Moving<MeshShape>& b, const Ask& ask);

// The first contact in the gap between the end of a turn and a pose.
std::optional<Wrong> ask_about_settling(const Turning<MeshShape>& a, const Pose& to, const Posed<MeshShape>& b,
                                        const Ask& ask);

}  // namespace ecods::judge
