// Pairs of posed triangles on which predicates fail, by family; some with answers that are known without any predicate.
//
// All are deterministic: a family and a random generator's state give the same bits on every machine.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "ecods/pose.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

struct PosedPair {
    Pose pose_a;
    Pose pose_b;
    std::array<Vec3, 3> a;
    std::array<Vec3, 3> b;
    std::optional<bool> intersects;  // where the recipe knows it
};

enum class HardFamily {
    generic,            // two random triangles that come near each other, in random poses
    lattice,            // small integer corners in a random basis with full mantissas, one random pose for both
    lattice_one_ulp,    // the same, one coordinate a unit in the last place off
    coplanar,           // both in one lattice plane, in one random pose
    edge_on_edge,       // two edges that cross in one lattice point, in one random pose
    vertex_on_face,     // known: a vertex in the interior of a face, the rest on one side; one random pose for both
    vertex_near_face,   // known: the same, that vertex one or two units in the last place above or below
    integer_rotations,  // small lattice triangles, each body under a scaled rotation of integers of its own
    vertex_on_face_integer,    // known: vertex_on_face, each body under an integer rotation of its own
    vertex_near_face_integer,  // known: vertex_near_face, likewise
    permutations,              // corners of touching boxes of 45-bit sizes, each under a signed permutation matrix
    equal_poses,               // lattice triangles, full-mantissa corners, bitwise equal poses
    short_coordinates,         // small integers times one power of two, translated likewise: touching bricks
    far_from_origin,           // lattice in one rotation, translated by 1 to 1e12
    slivers,                   // triangles thin by 1 to 2^-40, against one another
    wide_exponents,            // lattice with entries of R and v spread over 2^-300
    scaled,                    // lattice_one_ulp at scales of 2^-300 to 2^300
    extreme_scales,            // lattice at scales of 2^-1060 to 2^1000: subnormal and huge
    singular,                  // R with a zero or repeated column: both bodies are flat or thin
    degenerate,                // zero-area triangles: repeated and collinear corners, lattice
};

std::span<const HardFamily> hard_families();
std::string_view name(HardFamily family);

PosedPair make_pair(HardFamily family, Random& random);

}  // namespace ecods::scenes
