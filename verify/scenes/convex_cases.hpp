// Pairs of posed convex solids on which distances and depths go wrong, by family; of some the numbers follow from how
// they are made.
//
// All are deterministic: a family and a random generator's state give the same bits on every machine.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scenes/lattice_mesh.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

struct ConvexCase {
    PosedMesh a, b;
    // Where the recipe knows them: one of the two, or both as 0 where they touch.
    std::optional<double> distance = {};
    std::optional<double> depth = {};
};

enum class ConvexFamily {
    hulls,              // of points on ellipsoids, in random rotations: apart, or deep in each other
    near_contact,       // the same, a vertex and a face or two edges apart or deep by 2^-1 to 2^-52, or by rounding
    aligned_boxes,      // known: two boxes of the lattice in one signed permutation
    turned_boxes,       // boxes in rotations of their own, near contact or deep
    integer_rotations,  // known: one box, and a vertex, an edge or a face of another, each in an integer rotation
    lattice_hulls,      // of a few small integers under one affine map: contacts and ties of many features
    prisms,             // of 3 to 24 sides, in one frame: parallel faces and edges
    plates,             // boxes of 500 by 500 by 1, crossed, in each other or nearly coplanar
    needles,            // 2^-10 to 2^-40 as thick as long
    arcs,               // a face of up to 105 vertices nearly on a line: an arc 2^-14 to 2^-50 as high as long
    many_in_one_plane,  // lattice hulls and boxes whose faces are cut in hundreds of triangles
    inside,             // a small one in a large one
    equal,              // a solid and itself, or another mesh of it, at one pose or nearly
    far,                // near contact, and 1e8, 2^50 or more from the origin
    squeezed,           // a column of the matrix is 2^-10 to 2^-60 of the others, or they are sheared, or reflect
    scaled,             // at scales of 2^-900 to 2^900
    subnormal,          // integers of some digits, times 2^-1074
    exponents,          // tetrahedra of coordinates of any exponents
    nudged,             // one of the above, a number of a pose moved by one ulp
};

std::span<const ConvexFamily> convex_families();
std::string_view name(ConvexFamily family);

ConvexCase make_convex_case(ConvexFamily family, Random& random);

// Moves b, in doubles, so that a vertex of one is above the middle of a triangle of the other by `gap`, or the middles
// of two edges are so far apart; into the other solid where it is negative.
void bring_near(ConvexCase& made, double gap, Random& random);

}  // namespace ecods::scenes
