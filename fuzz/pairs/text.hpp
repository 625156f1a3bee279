// A pair of posed triangles as text from which it can be made again, bit for bit.
#pragma once

#include <string>

#include "scenes/cast_cases.hpp"
#include "scenes/convex_cases.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/hit_cases.hpp"
#include "scenes/solid_cases.hpp"
#include "scenes/turn_cases.hpp"

namespace ecods::fuzz {

// Hexadecimal floats; for either body R by rows, t and the three corners.
std::string to_text(const scenes::PosedPair& pair);

// Of either body R by rows, t, all vertices and all triangles.
std::string to_text(const scenes::DistanceCase& made);
std::string to_text(const scenes::SolidCase& made);
std::string to_text(const scenes::ConvexCase& made);

// The same, and the line; the motion; both poses of each; the turn.
std::string to_text(const scenes::HitCase& made);
std::string to_text(const scenes::CastCase& made);
std::string to_text(const scenes::MoveCase& made);
std::string to_text(const scenes::TurnCase& made);

}  // namespace ecods::fuzz
