// Declares the functions of hit.hpp for the surface of a body: all triangles of the body's mesh, for any form of shape.
#pragma once

#include <optional>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods::surface {

std::optional<Hit> first_hit(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask);
std::optional<Hit> first_hit(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask);
std::vector<Hit> all_hits(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask);
std::vector<Hit> all_hits(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask);

}  // namespace ecods::surface
