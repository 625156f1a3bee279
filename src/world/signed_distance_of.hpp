// Finds the signed distance of two bodies of a world, if they have one: of two convex bodies, or of a body and a half
// space.
#pragma once

#include <optional>

#include "ecods/solid.hpp"
#include "query/body/rounded_pair.hpp"
#include "world/bodies.hpp"

namespace ecods {

// Two convex solids at regular poses.
struct ConvexSolids {
    Posed<ConvexSolid> a, b;
};
std::optional<ConvexSolids> as_convex_solids(const Posed<Shape>& a, const Posed<Shape>& b);

// Returns the pair if one of the two is a rounded body, and the other one or a mesh.
std::optional<RoundedPair> as_rounded_pair(const Posed<Shape>& a, const Posed<Shape>& b);

// True if signed_distance_of() gives the signed distance of the two.
bool have_signed_distance(const Posed<Shape>& a, const Posed<Shape>& b);

// Returns the signed distance; nullopt if the two have none. Throws SingularPose, whose argument counts the two, if the
// pose of a half space is singular. A convex solid at a singular pose has no inside, and no signed distance; nor has a
// rounded body with such a core, or with one that is not convex.
std::optional<SignedDistance> signed_distance_of(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask);

// Exchanges the two bodies of the answer.
void turn(SignedDistance& found) noexcept;

}  // namespace ecods
