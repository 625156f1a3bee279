// Parts in exact contact over whole faces, and the same parts with a clearance: what assemblies are full of, and what
// rounding answers at random.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scenes/mesh_pairs.hpp"

namespace ecods::scenes {

// Bricks of 192 triangles in a wall: every query is of two that lie face on face, or, every other one, that are parted
// by 2^-20 of their length. Half of the queries are axis-aligned and differ in translation, half have one random pose
// for both, with the offset in the mesh; contact is exact in both.
MeshPairs stacked_bricks(std::size_t count, std::uint32_t seed);

// A shaft with 24 teeth in the hub cut for it, all flanks in contact; every other query has a shaft thinner by one part
// in 4096, which touches nothing. 1,536 triangles each. Both bodies have one pose: random, or axis-aligned with
// the shaft pushed along its axis.
MeshPairs splined_shafts(std::size_t count, std::uint32_t seed);

}  // namespace ecods::scenes
