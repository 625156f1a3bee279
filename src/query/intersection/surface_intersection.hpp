// Declares the questions of intersection.hpp about the surfaces of two bodies: all triangles of their meshes, whatever
// forms their shapes have.
#pragma once

#include <vector>

#include "ecods/ask.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods::surface {

// Returns true if the surfaces share a point. Leaves in the witness two triangles that share a point, or an axis that
// separates the bodies as a whole, insides included, or neither.
bool intersects(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);
// Returns the same for two shapes that must be MeshShapes, without copies of their poses: this is the question that a
// world asks most often.
bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask);
bool holds_axis(const PairWitness& witness) noexcept;

Relation relation(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);
std::vector<TrianglePair> intersecting_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);

}  // namespace ecods::surface
