// This header declares the contact patch of a convex body and a half space.
#pragma once

#include "ecods/contact.hpp"
#include "ecods/solid.hpp"
#include "query/patch/convex_body.hpp"

namespace ecods::patches {

// Returns the patch of both bodies in the caller's order; the limits must be valid. `argument` is the number of the
// half space in the caller's question, 0 or 1.
ContactPatch patch_on_plane(const ConvexBody& body, const Posed<HalfSpace>& half_space, int argument,
                            const PatchLimits& limits);

}  // namespace ecods::patches
