// What is in the way, in all worlds after every update: segments and rays, bodies that are cast, and all that meet
// while bodies go to new poses; against asking all bodies, or all pairs, one by one.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "ecods/primitives.hpp"
#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// Worlds that were given the same calls; the seed chooses what is asked. Each throws CheckFailed unless all worlds
// answer what the first one's bodies say.
void check_hits(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);
// ... and in all bits what the oracle says of one world, where bodies have few triangles.
void check_hit_order(const World& world, const std::variant<Segment, Ray>& line, Counters& counters);
void check_casts(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);
void check_meetings(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);

// The mesh of a body at its pose; of a shape of the caller's own, the mesh that it is.
Posed<MeshShape> mesh_at(const World& world, BodyId body);

// A point that bodies are near: a corner of a mesh at its pose, or of a box. Points that are no doubles are left out.
Vec3 any_point(const World& world, const std::vector<BodyId>& bodies, scenes::Random& random);

// True if all pairs can be asked in a fraction of a second.
bool are_soon_asked(const World& world, const std::vector<BodyId>& bodies);

}  // namespace ecods::fuzz
