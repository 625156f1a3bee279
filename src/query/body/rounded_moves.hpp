// Straight moves and turns of rounded bodies that are translations, as exact vectors.
#pragma once

#include <optional>

#include "ecods/motion.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/number/long_vector.hpp"

namespace ecods {

// Returns the vector by which a rounded body with this core is translated until it is at the pose `end`, or by the
// motion; nullopt if it is not translated. A body is translated if its matrix stays. So is a ball, by any matrices:
// its core is one point, which goes straight; and by a turn, if that point is on the axis. No way of several legs is a
// translation. A translation of 0 is one.
std::optional<exact::ScaledLongVector> translation_of(const Posed<MeshShape>& core, const Pose& end);
std::optional<exact::ScaledLongVector> translation_of(const Posed<MeshShape>& core, const Motion& motion);

}  // namespace ecods
