// What is in the way, in all worlds after every update: segments and rays, bodies that are cast, and all that meet
// while bodies go to new poses, turn or are translated; against asking all bodies, or all pairs, one by one.
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "ecods/primitives.hpp"
#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"

namespace ecods::fuzz {

// Worlds that were given the same calls; the seed chooses what is asked. Each throws CheckFailed unless all worlds
// answer what the first one's bodies say.
void check_hits(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);
// ... and in all bits what the oracle says of one world, where bodies have few triangles.
void check_hit_order(const World& world, const std::variant<Segment, Ray>& line, Counters& counters);
void check_casts(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);
void check_meetings(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);
// A body turns while others are translated, or rest; against the oracle, too, where they have few triangles.
void check_turns(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);

}  // namespace ecods::fuzz
