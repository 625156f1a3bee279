// Computes the contact patch of a convex body and a half space.
#pragma once

#include "ecods/contact.hpp"
#include "ecods/half_space.hpp"
#include "query/patch/convex_body.hpp"

namespace ecods::patches {

// Returns the patch, with the body as the first and the half space as the second one; the limits must be valid.
// `argument` is the number of the half space in the caller's question, so that a SingularPose names the right body.
ContactPatch patch_on_plane(const ConvexBody& body, const Posed<HalfSpace>& half_space, int argument,
                            const PatchLimits& limits);

}  // namespace ecods::patches
