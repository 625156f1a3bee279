// Two boxes whose faces, edges or corners are in exact contact, or an ulp beside it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scenes/mesh_pairs.hpp"

namespace ecods::fuzz {

enum class BoxTurn {
    none,             // bodies differ by a translation
    common_rotation,  // one random pose for both; the offset is in the mesh
    permutations,     // each body under a signed permutation matrix of its own
};

struct BoxRecipe {
    int bits = 4;  // of sizes and offsets, which are below 1
    BoxTurn turn = BoxTurn::none;
    int ulps = 0;               // a coordinate of the second box, in its mesh, is off by so many
    int far_exponent_max = 0;   // translated by 2^0 to 2^this, if not 0
    int thin_exponent_max = 0;  // one size is divided by 2^10 to 2^this, if not 0
};

scenes::MeshPairs box_pairs(const BoxRecipe& recipe, std::size_t count, std::uint32_t seed);

}  // namespace ecods::fuzz
