// Convex solids, after every update: what worlds say of all pairs of them, by asking two at a time.
#pragma once

#include <cstdint>
#include <span>

#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"

namespace ecods::fuzz {

// Worlds that were given the same calls: depths and distances of their convex solids are what the first one's bodies
// say, and so are questions about some pair, in either order; the seed chooses limits and pair. Throws CheckFailed.
void check_convex(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);

}  // namespace ecods::fuzz
