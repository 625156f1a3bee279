// Which nodes of two trees may meet while both bodies go on straight lines from one pose to another, and from when on.
//
// For a fixed axis n the gap between two boxes (or triangles), min n . q - max n . p, is a concave function of time:
// each corner moves linearly, so that the minimum is one of linear functions. It is nowhere below its chord between two
// times. So boxes whose gap is positive at both are apart throughout; where it is positive at one of them, they are
// apart from there to the chord's zero. On several axes, each in both directions, the times that are left may have no
// common one. Half-way between its poses a body is the mean of both, with n the same: so chords are loose only by how
// much boxes turn, times their own size, and that is least for small boxes.
//
// The sets are those of separating_axes.hpp, with its bounds, each twice: for the poses at the start and at the end, on
// the same axes. Coordinates are relative to the first body's translation, which moves linearly, too.
#pragma once

#include <array>
#include <cstdint>

#include "bvh/axes/separating_axes.hpp"

namespace ecods {

// A tree on its way between two poses, by reference.
struct MovingTree {
    const MeshBvh& tree;
    const Mat3& from;
    const Mat3& to;
};

// Three axes at both ends of the motion.
struct MotionSet {
    AxisSet start, end;
};

class MotionAxes {
  public:
    // The differences are fl(t_b - t_a) at the start and at the end.
    void bind(const MovingTree& a, const MovingTree& b, const Vec3& d_from, const Vec3& d_to);

    const std::array<MotionSet, 2>& sets() const noexcept { return sets_; }

  private:
    std::array<MotionSet, 2> sets_;
};

// Returns a mask of the pairs of lanes that may meet at a time up to `limit`, as overlap_mask does, and sets a time for
// each of them, not negative, before which they certainly do not.
template <class X, class Y>
std::uint64_t meeting_mask(const std::array<MotionSet, 2>& sets, float limit, const X& x, const Y& y,
                           LaneBounds& times) noexcept;

}  // namespace ecods
