// Pairs of posed solids, by family; of most families the answers follow from how they are made.
// The table of solid_cases.cpp says what each family makes.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "ecods/solid.hpp"
#include "scenes/families.hpp"
#include "scenes/lattice_mesh.hpp"

namespace ecods::scenes {

// Where a point is with respect to the first solid of a case.
struct KnownSide {
    Vec3 point;
    Side side = Side::outside;
};

struct SolidCase {
    PosedMesh a, b;
    std::optional<Relation> relation;  // where the recipe knows it
    std::vector<KnownSide> points;     // the same

    // Those alone.
    std::vector<Vec3> known_points() const {
        std::vector<Vec3> result;
        for (const KnownSide& known : points) result.push_back(known.point);
        return result;
    }
};

Families<SolidCase> solid_families();

// A recipe of two solids on the lattice.
struct LatticePair {
    std::string_view name;
    LatticeMesh a, b;
    Relation relation;
};

// Contacts that are easily taken for something else: an octahedron inscribed in a cube, a convex edge in a face, roofs
// that cross at a point, solids that share an edge, a vertex or part of a face, equal solids of other triangles.
const std::vector<LatticePair>& fixed_contacts();

}  // namespace ecods::scenes
