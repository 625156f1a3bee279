// Finds the signed distance of two bodies of a world, if they have one: if both are convex, or one is a half space.
#pragma once

#include <optional>

#include "ecods/solid.hpp"
#include "query/body/rounded_pair.hpp"
#include "world/bodies.hpp"

namespace ecods {

// ConvexSolids are two convex solids at regular poses.
struct ConvexSolids {
    Posed<ConvexSolid> a, b;
};
std::optional<ConvexSolids> as_convex_solids(const Posed<Shape>& a, const Posed<Shape>& b);

// Returns the two bodies as a RoundedPair if at least one of them is a rounded body, and the other one is rounded or a
// mesh; otherwise nullopt.
std::optional<RoundedPair> as_rounded_pair(const Posed<Shape>& a, const Posed<Shape>& b);

// Returns true if signed_distance_of() returns a distance for the two bodies, not nullopt.
bool have_signed_distance(const Posed<Shape>& a, const Posed<Shape>& b);

// Returns the signed distance; nullopt if the two have none. A convex solid at a singular pose has no inside, and no
// signed distance; the same holds for a rounded body whose core is such a solid, or is not convex. If the pose of a
// half space is singular, throws SingularPose, with argument 0 for a and 1 for b.
std::optional<SignedDistance> signed_distance_of(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask);

// Exchanges the two bodies of the answer.
void turn(SignedDistance& found) noexcept;

}  // namespace ecods
