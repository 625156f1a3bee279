#include "scenes/hard_pairs.hpp"

#include <array>

#include "scenes/hard_pair_parts.hpp"
#include "scenes/hard_pair_recipes.hpp"

namespace ecods::scenes {
namespace {

using namespace hard;

constexpr std::array families{HardFamily::generic,
                              HardFamily::lattice,
                              HardFamily::lattice_one_ulp,
                              HardFamily::coplanar,
                              HardFamily::edge_on_edge,
                              HardFamily::vertex_on_face,
                              HardFamily::vertex_near_face,
                              HardFamily::integer_rotations,
                              HardFamily::vertex_on_face_integer,
                              HardFamily::vertex_near_face_integer,
                              HardFamily::permutations,
                              HardFamily::equal_poses,
                              HardFamily::short_coordinates,
                              HardFamily::far_from_origin,
                              HardFamily::slivers,
                              HardFamily::wide_exponents,
                              HardFamily::scaled,
                              HardFamily::extreme_scales,
                              HardFamily::singular,
                              HardFamily::degenerate};

}  // namespace

std::span<const HardFamily> hard_families() {
    return families;
}

std::string_view name(HardFamily family) {
    switch (family) {
        case HardFamily::generic:
            return "generic";
        case HardFamily::lattice:
            return "lattice";
        case HardFamily::lattice_one_ulp:
            return "lattice, one ulp";
        case HardFamily::coplanar:
            return "coplanar";
        case HardFamily::edge_on_edge:
            return "edge on edge";
        case HardFamily::vertex_on_face:
            return "vertex on face";
        case HardFamily::vertex_near_face:
            return "vertex near face";
        case HardFamily::integer_rotations:
            return "integer rotations";
        case HardFamily::vertex_on_face_integer:
            return "vertex on face, integer rotations";
        case HardFamily::vertex_near_face_integer:
            return "vertex near face, integer rotations";
        case HardFamily::permutations:
            return "permutation matrices";
        case HardFamily::equal_poses:
            return "equal poses";
        case HardFamily::short_coordinates:
            return "short coordinates";
        case HardFamily::far_from_origin:
            return "far from origin";
        case HardFamily::slivers:
            return "slivers";
        case HardFamily::wide_exponents:
            return "wide exponents";
        case HardFamily::scaled:
            return "scaled";
        case HardFamily::extreme_scales:
            return "extreme scales";
        case HardFamily::singular:
            return "singular";
        case HardFamily::degenerate:
            return "degenerate";
    }
    return "unknown";
}

PosedPair make_pair(HardFamily family, Random& random) {
    switch (family) {
        case HardFamily::generic:
            return generic(random);
        case HardFamily::lattice:
            return lattice(random);
        case HardFamily::lattice_one_ulp: {
            PosedPair pair = lattice(random);
            nudge_one(pair, random);
            return pair;
        }
        case HardFamily::coplanar:
            return coplanar(random);
        case HardFamily::edge_on_edge:
            return edge_on_edge(random);
        case HardFamily::vertex_on_face:
            return vertex_on_face(random, 0);
        case HardFamily::vertex_near_face:
            return vertex_on_face(random, integer(random, 1, 2));
        case HardFamily::integer_rotations:
            return integer_rotations(random);
        case HardFamily::vertex_on_face_integer:
            return vertex_on_face_integer(random, 0);
        case HardFamily::vertex_near_face_integer:
            return vertex_on_face_integer(random, integer(random, 1, 2));
        case HardFamily::permutations:
            return permutations(random);
        case HardFamily::equal_poses:
            return lattice(random);
        case HardFamily::short_coordinates:
            return short_coordinates(random);
        case HardFamily::far_from_origin:
            return far_from_origin(random);
        case HardFamily::slivers:
            return slivers(random);
        case HardFamily::wide_exponents:
            return wide_exponents(random);
        case HardFamily::scaled:
            return scaled(random, -300, 300);
        case HardFamily::extreme_scales:
            return coin(random) ? scaled(random, -1060, -1000) : scaled(random, 900, 1000);
        case HardFamily::singular:
            return singular(random);
        case HardFamily::degenerate:
            return degenerate(random);
    }
    return generic(random);
}

}  // namespace ecods::scenes
