// SegmentBounds is a segment that is prepared for tests against many boxes.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/primitives.hpp"

namespace ecods {

// Says what doubles and a bound prove about a set of points and a box.
enum class BoxVerdict : std::uint8_t { apart, meeting, unknown };

// Separating axes of a segment and a box are the three coordinate axes and their three cross products with the
// segment's direction. These suffice for flat boxes, points and segments of length zero, too: enlarge the box by a cube
// so small that the two stay apart; the axes of the resulting solid are among the six.
//
// On the coordinate axes comparisons decide. The other three are decided in the projection along each coordinate axis,
// in the plane (y, z): does the box lie on one side of the line through the ends a and b? Only the part of the box
// within the segment's own box matters, so every number is a difference of coordinates there, and sides at infinity
// never enter.
//
// Bound. Let D_y and D_z be the magnitudes of b - a, and u' = 2^-52 (any rounding mode). A corner (y, z) of that part
// gives s = d_y (z - a_z) - d_z (y - a_y), each product with three roundings of at most D_y D_z: 3.01 u', and one for
// the difference, at most 2.01 D_y D_z: together below 8.1 u' D_y D_z; 16 u' |d_y| |d_z| has margin for its own
// evaluation. Underflow, subnormals taken for zero included, loses 2^-1020 in a difference, which is multiplied by the
// largest extent E, and in a product: below 2^-1000 E + 2^-1010. Overflow: if E is 2^500 or more, nothing is proved.
// Claim: verify/proofs/small_bounds.py
class SegmentBounds {
  public:
    explicit SegmentBounds(const Segment& segment) noexcept;

    // Returns the smallest box that contains the segment.
    const Aabb& box() const noexcept { return box_; }

    // Decides a box that overlaps box() by doubles and the bound.
    BoxVerdict judge(const Aabb& box) const noexcept;

    // Returns overlap(segment, box).
    bool meets(const Aabb& box) const noexcept;

  private:
    // Returns the corner of the clipped box, projected along an axis, with the largest s (side 1) or the least s (side
    // -1).
    std::array<double, 2> corner(const Aabb& box, int y, int z, int side) const noexcept;

    Segment segment_;
    Aabb box_;
    Vec3 direction_;               // b - a, rounded
    std::array<int, 3> sign_;      // sign of b - a
    std::array<double, 3> bound_;  // error bound of s, by the axis of projection
};

}  // namespace ecods
