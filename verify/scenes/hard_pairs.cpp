#include "scenes/hard_pairs.hpp"

#include "scenes/hard_pair_parts.hpp"
#include "scenes/hard_pair_recipes.hpp"

namespace ecods::scenes {
namespace {

using namespace hard;

PosedPair lattice_one_ulp(Random& random) {
    PosedPair pair = lattice(random);
    nudge_one(pair, random);
    return pair;
}

PosedPair extreme_scales(Random& random) {
    return coin(random) ? scaled(random, -1060, -1000) : scaled(random, 900, 1000);
}

constexpr Family<PosedPair> table[] = {
    {"generic", generic},  // two random triangles that come near each other, in random poses
    // Small integer corners in a random basis with full mantissas, one random pose for both
    {"lattice", lattice},
    {"lattice, one ulp", lattice_one_ulp},  // the same, one coordinate a unit in the last place off
    {"coplanar", coplanar},                 // both in one lattice plane, in one random pose
    {"edge on edge", edge_on_edge},         // two edges that cross in one lattice point, in one random pose
    // Known: a vertex in the interior of a face, the rest on one side; one random pose for both
    {"vertex on face", [](Random& random) { return vertex_on_face(random, 0); }},
    // Known: the same, that vertex one or two units in the last place above or below
    {"vertex near face", [](Random& random) { return vertex_on_face(random, integer(random, 1, 2)); }},
    // Small lattice triangles, each body under a scaled rotation of integers of its own
    {"integer rotations", integer_rotations},
    // Known: vertex_on_face, each body under an integer rotation of its own
    {"vertex on face, integer rotations", [](Random& random) { return vertex_on_face_integer(random, 0); }},
    // Known: vertex_near_face, likewise
    {"vertex near face, integer rotations",
     [](Random& random) { return vertex_on_face_integer(random, integer(random, 1, 2)); }},
    // Corners of touching boxes of 45-bit sizes, each under a signed permutation matrix
    {"permutation matrices", permutations},
    {"equal poses", lattice},  // lattice triangles, full-mantissa corners, bitwise equal poses
    // Small integers times one power of two, translated likewise: touching bricks
    {"short coordinates", short_coordinates},
    {"far from origin", far_from_origin},  // lattice in one rotation, translated by 1 to 1e12
    {"slivers", slivers},                  // triangles thin by 1 to 2^-40, against one another
    {"wide exponents", wide_exponents},    // lattice with entries of R and v spread over 2^-300
    // lattice_one_ulp at scales of 2^-300 to 2^300
    {"scaled", [](Random& random) { return scaled(random, -300, 300); }},
    {"extreme scales", extreme_scales},  // lattice at scales of 2^-1060 to 2^1000: subnormal and huge
    {"singular", singular},              // R with a zero or repeated column: both bodies are flat or thin
    {"degenerate", degenerate},          // zero-area triangles: repeated and collinear corners, lattice
};

}  // namespace

Families<PosedPair> hard_families() {
    return table;
}

}  // namespace ecods::scenes
