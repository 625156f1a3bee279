// The axis along which two triangles are as far apart as they are: that of their closest features.
#pragma once

#include <cstdint>

#include "ecods/closest_points.hpp"
#include "ecods/shape.hpp"
#include "query/certificate/proof.hpp"
#include "query/distance/triangle_distances.hpp"

namespace ecods {

// Of triangles that do not meet.
AxisFormula formula_of(const ClosestPoints& closest);

// Of triangle `of_a` of one body and `of_b` of another, where the interval is certain and not of 0.
AxisFormula formula_of(const DistanceInterval& interval, const Posed<MeshShape>& body_a, std::uint32_t of_a,
                       const Posed<MeshShape>& body_b, std::uint32_t of_b);

// About the vector that the formula makes, of those between features.
Vec3 direction_along(const AxisFormula& f, const Posed<MeshShape>& body_a, std::uint32_t of_a,
                     const Posed<MeshShape>& body_b, std::uint32_t of_b);

}  // namespace ecods
