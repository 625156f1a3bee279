// This header declares the contact patch of two posed hulls, each with a radius around it.
#pragma once

#include "ecods/contact.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "query/convex/posed_hulls.hpp"
#include "query/patch/reduce.hpp"

namespace ecods::patches {

// Returns the contact patch of the hulls with `radii`; the limits must be valid. Starts the search from the pair of
// triangles in `witness`, and sets `witness` to the pair that the search found.
ContactPatch patch_of_hulls(convex::PosedHulls& hulls, const exact::Radii& radii, const PatchLimits& limits,
                            QueryMemory& memory, PairWitness& witness);

// Sets corner_count to the number of corners, and then removes all corners that choose_corners() does not choose;
// max_corners = 0 keeps all corners. The corners must be in order around the normal. `exact` must return the exact
// positions of the corners on either body.
void keep_corners(ContactPatch& patch, std::uint32_t max_corners, const ExactCorners& exact);

// ListedCorners returns exact corners from a list.
class ListedCorners final : public ExactCorners {
  public:
    ListedCorners(const std::vector<LongPoint>& points, const ScaledLongVector& normal) noexcept
        : points_(points), normal_(normal) {}
    LongPoint point(std::size_t i) const override { return points_[i]; }
    ScaledLongVector normal() const override { return normal_; }

  private:
    const std::vector<LongPoint>& points_;
    const ScaledLongVector& normal_;
};

}  // namespace ecods::patches
