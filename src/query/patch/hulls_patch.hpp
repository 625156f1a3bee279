// Computes the contact patch of two posed hulls with radii around them.
#pragma once

#include "ecods/contact.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "query/convex/posed_hulls.hpp"
#include "query/patch/reduce.hpp"

namespace ecods::patches {

// Returns the patch; the limits must be valid. The search starts from `witness`, and sets it to the pair that it found.
ContactPatch patch_of_hulls(convex::PosedHulls& hulls, const exact::Radii& radii, const PatchLimits& limits,
                            QueryMemory& memory, PairWitness& witness);

// Sets corner_count to the number of corners, and then removes those that choose_corners() leaves out; max_corners = 0
// keeps all. The corners must be in order around the normal. point(i) must return the exact position of corner i on
// either body.
template <class Point>
void keep_corners(ContactPatch& patch, std::uint32_t max_corners, const ScaledLongVector& normal, const Point& point) {
    patch.corner_count = static_cast<std::uint32_t>(patch.corners.size());
    if (max_corners == 0 || patch.corners.size() <= max_corners) return;
    std::vector<LongPoint> points;
    for (std::size_t i = 0; i < patch.corners.size(); ++i) points.push_back(point(i));
    std::size_t kept = 0;
    for (const std::size_t i : choose_corners(points, normal, max_corners)) patch.corners[kept++] = patch.corners[i];
    patch.corners.resize(kept);
}

}  // namespace ecods::patches
