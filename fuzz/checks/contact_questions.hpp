// Asks the questions of cast.hpp and contact.hpp about two bodies of a world that are
// meshes, of which one is translated: when it enters the other one, where both first touch, and when they are first
// within a distance.
#pragma once

#include <cstdint>
#include <span>

#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// Worlds that were given the same calls; the seed chooses two bodies and a motion. Throws CheckFailed unless
//  - entering() says the same in both orders and up to limits of time; bodies that share inner points at a sample of
//    time, by the oracle, have entered by then; between an entry and such a sample convex bodies overlap at all
//    samples; a surface enters no earlier than its solid; and pose_before() is a pose at which nothing overlaps;
//  - the point of a first contact is in a box of three doubles around a point of the body at rest, and the normal is
//    that of the exchanged bodies, turned around, and points along the motion;
//  - cast_to_distance() is that of all pairs of triangles by the oracle, or at least at that distance or further at
//    samples before it, and is the same in both orders and up to limits of time;
//  - a surface whose vertices each go to a place of their own meets the other one as the oracle says;
//  - and check_contacts_of_world() finds nothing wrong, if all bodies are meshes.
void check_contacts(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);

// Throws CheckFailed unless entering(), up to limits of time, contact_point(), and the cast of a deforming mesh are
// those of two bodies: of the first one. `own` is translated by the motion. All bodies must be meshes.
void check_contacts_of_world(const World& world, BodyId own, const Vec3& motion, scenes::Random& random,
                             QueryMemory& memory, Counters& counters);

}  // namespace ecods::fuzz
