// Declares relations of solids, and of a surface to a solid.
#pragma once

#include "ecods/ask.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// The relations follow from signs of determinants of input points alone. If two triangles that are not coplanar share a
// segment, the half-planes of both solids around the segment's line, sorted by angle, show which regions exist beside
// the segment. A shell without such a segment lies on one side of the other solid; one ray decides on which, from a
// point that is moved symbolically. README.md proves that no other case exists.

// Returns the relation of two solids: apart, touching, overlapping, inside, contains or equal. A solid at a singular
// pose is apart from or touching another solid; inside the other solid, the relation is touching.
Relation solid_relation(const Posed<Solid>& a, const Posed<Solid>& b, const Ask& ask);

// Returns the relation of a surface to a solid: apart, touching, crossing or inside. All triangles of the surface
// count, also if the surface is the mesh of a solid.
Relation surface_relation(const Posed<MeshShape>& surface, const Posed<Solid>& solid, const Ask& ask);

// Returns the relation of the second body to the first.
constexpr Relation mirrored(Relation relation) noexcept {
    return relation == Relation::inside     ? Relation::contains
           : relation == Relation::contains ? Relation::inside
                                            : relation;
}

}  // namespace ecods
