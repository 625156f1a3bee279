// Computes the exact translation vectors of straight moves and turns that only translate a rounded body.
#pragma once

#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/number/long_vector.hpp"

namespace ecods {

// Returns the vector by which a rounded body with this core is translated until it is at the pose `end`, or by the
// motion; nullopt if it is not translated. A body is translated if its matrix stays. A ball, whose core is one point,
// is also translated if it goes straight to any pose, or if the point is on the axis of its turn. The translation may
// be 0. No way of several legs is a translation.
std::optional<exact::ScaledLongVector> translation_of(const Posed<MeshShape>& core, const Pose& end);
std::optional<exact::ScaledLongVector> translation_of(const Posed<MeshShape>& core, const Motion& motion);

}  // namespace ecods
