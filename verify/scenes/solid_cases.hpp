// Pairs of posed solids, by family; of most families the answers follow from how they are made.
//
// All are deterministic: a family and a random generator's state give the same bits on every machine.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ecods/solid.hpp"
#include "scenes/lattice_mesh.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

// Where a point is with respect to the first solid of a case.
struct KnownSide {
    Vec3 point;
    Side side = Side::outside;
};

struct SolidCase {
    PosedMesh a, b;
    std::optional<SolidRelation> relation;  // where the recipe knows it
    std::vector<KnownSide> points;          // the same

    // Those alone.
    std::vector<Vec3> known_points() const {
        std::vector<Vec3> result;
        for (const KnownSide& known : points) result.push_back(known.point);
        return result;
    }
};

enum class SolidFamily {
    polycubes,      // known: sets of cells in a grid of 2 to 4, biased to subsets, complements and neighbours
    shells,         // known: cubes in cubes in cubes, some layers of them filled
    boxes,          // known: two boxes with ends among a few integers, so that sides are flush
    kuhn,           // known: sets of the tetrahedra into which the diagonals cut the cells
    contacts,       // known: one of fixed_contacts()
    common_pose,    // known: polycubes in one pose of any numbers
    singular,       // a pose without an inverse; known if both have it and nothing is inside
    nudged,         // one of the above, a number of a pose or a coordinate of it moved by one ulp: solids for most
    kuhn_mixed,     // two lattices with their own mirroring and size
    tetrahedra,     // small ones, corners of one on faces, edges and corners of the other
    bodies,         // boxes, spheres and tori in random poses
    exponents,      // tetrahedra of coordinates of any exponents
    no_solid_area,  // known: triangles of zero area alone, and something else
};

std::span<const SolidFamily> solid_families();
std::string_view name(SolidFamily family);

SolidCase make_solid_case(SolidFamily family, Random& random);

// A recipe of two solids on the lattice.
struct LatticePair {
    std::string_view name;
    LatticeMesh a, b;
    SolidRelation relation;
};

// Contacts that are easily taken for something else: an octahedron inscribed in a cube, a convex edge in a face, roofs
// that cross at a point, solids that share an edge, a vertex or part of a face, equal solids of other triangles.
const std::vector<LatticePair>& fixed_contacts();

}  // namespace ecods::scenes
