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
// keeps all. The corners must be in order around the normal. `exact` must have their exact positions on either body.
void keep_corners(ContactPatch& patch, std::uint32_t max_corners, const ExactCorners& exact);

// ListedCorners refers to a list of exact corners.
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
