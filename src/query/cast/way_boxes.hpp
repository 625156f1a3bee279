// WayBoxes computes boxes that contain a body on the legs of a way, from a box that contains it at the start. The boxes
// only exclude bodies that cannot meet; no result depends on a box.
//
// Bound. A body is rigid, so each of its points keeps its distance from the pivot. The distance is a convex function of
// the point, so at the start it is greatest at a corner of the box: at most |h|, with h the greatest |p - c| on each
// axis. The differences are off by u' of themselves, and the length as computed by less than 8 u'. Squares that are
// lost are below 2^-1021, so a length is off by less than 2^-508 besides; 2^-500 is added. On a leg the pivot is
// between its two places, and the box of these, wider by the radius on each side and rounded outwards, contains the
// body.
// Claim: verify/proofs/turn_pieces.md
#pragma once

#include <cstddef>
#include <span>

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

class WayBoxes {
  public:
    // Takes a box that contains the body at the start, and valid nodes, to which this object refers.
    WayBoxes(const Aabb& start, std::span<const WayNode> nodes);

    // Returns a box that contains the body on a leg. Where coordinates may exceed 2^1000, the box is unbounded.
    Aabb of(std::size_t leg) const;
    // Returns a box that contains the body on all legs.
    Aabb whole() const;

    // Returns a double that is less than the share of the time at which the leg begins (motion.hpp).
    double before(std::size_t leg) const noexcept;

  private:
    std::span<const WayNode> nodes_;
    double radius_ = 0;
};

}  // namespace ecods
