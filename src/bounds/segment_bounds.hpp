// SegmentBounds is a segment, prepared for tests against many boxes.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/primitives.hpp"

namespace ecods {

// Says if a set of points and a box are proven apart or proven to share a point, by doubles with an error bound;
// otherwise `unknown`.
enum class BoxVerdict : std::uint8_t { apart, meeting, unknown };

// The separating axes of a segment and a box are the three coordinate axes and their cross products with the segment's
// direction. These six suffice for flat boxes, points and segments of length zero, too: enlarge the box by a cube
// so small that the two stay apart; the axes of the resulting solid are among the six.
//
// On the coordinate axes comparisons of ends decide. Each of the other three axes is decided in the projection along a
// coordinate axis x, in the plane (y, z): does the box lie on one side of the line through the segment's ends a and b?
// Only the part of the box inside the segment's own box matters. So all numbers are differences of coordinates in the
// segment's box, and infinite ends of the box do not enter.
//
// Bound. Let D_y and D_z be the magnitudes of b - a, and u' = 2^-52 (any rounding mode). A corner (y, z) of that part
// gives s = d_y (z - a_z) - d_z (y - a_y). Each product has three roundings and is at most D_y D_z: 3.01 u' D_y D_z.
// The difference of the two has one rounding and is at most 2.01 D_y D_z. Together these are below 8.1 u' D_y D_z; the
// bound 16 u' |d_y| |d_z| has a margin for its own evaluation. Underflow, also of subnormal numbers that are taken for
// zero, loses 2^-1020 in a difference, which is multiplied by the largest extent E, and in a product: below 2^-1000 E +
// 2^-1010. Overflow: if E is 2^500 or more, nothing is proved.
// Claim: verify/proofs/small_bounds.py
class SegmentBounds {
  public:
    explicit SegmentBounds(const Segment& segment) noexcept;

    // Returns the smallest box that contains the segment.
    const Aabb& box() const noexcept { return box_; }

    // Tests the segment against a box in floating-point arithmetic; returns `unknown` if the error bound does not allow
    // a decision. The box must overlap box().
    BoxVerdict judge(const Aabb& box) const noexcept;

    // Returns true if the segment and the box share a point. The result is exact, like that of overlap(segment, box).
    bool meets(const Aabb& box) const noexcept;

  private:
    // Returns the corner, as (y, z), at which s = d_y (z - a_z) - d_z (y - a_y) is largest (side 1) or least (side -1)
    // in the part of the box inside box().
    std::array<double, 2> corner(const Aabb& box, int y, int z, int side) const noexcept;

    Segment segment_;
    Aabb box_;
    Vec3 direction_;               // b - a, rounded
    std::array<int, 3> sign_;      // signs of the coordinates of b - a
    std::array<double, 3> bound_;  // error bounds of s, by the axis along which is projected
};

}  // namespace ecods
