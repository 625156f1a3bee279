// Answers about a body that goes along the nodes of a way in equal shares of the time (include/ecods/pose.hpp),
// judged by the oracle.
#pragma once

#include <optional>

#include "ecods/turn.hpp"
#include "judge/wrong.hpp"

namespace ecods::judge {

// Asks for the cast with b, which stays, in both orders, and at limits of time at and beside the answer. The time in
// the leg is the oracle's, and its share of the whole time is computed in rational numbers.
std::optional<Wrong> ask_about_along(const Way<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);

}  // namespace ecods::judge
