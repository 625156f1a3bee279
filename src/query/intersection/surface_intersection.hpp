// Declares the functions of intersection.hpp for the surfaces of two bodies: all triangles of their meshes, for any
// forms of shapes.
#pragma once

#include <vector>

#include "ecods/ask.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods::surface {

// Returns true if the surfaces share a point. Sets the witness to two triangles that share a point, or to an axis that
// separates the bodies as a whole, insides included, or to neither.
bool intersects(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);
// Returns true if the surfaces share a point, for two shapes that must be MeshShapes. The poses are not copied, because
// a world calls this function most often.
bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask);
bool holds_axis(const PairWitness& witness) noexcept;

Relation relation(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);
std::vector<TrianglePair> intersecting_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);

}  // namespace ecods::surface
