// Finds which nodes of two trees may meet while both bodies move on straight lines from one pose to another, and the
// earliest time at which they may.
//
// For a fixed axis n the gap between two boxes (or triangles), min n . q - max n . p, is a concave function of time:
// each corner moves linearly, so that the minimum is one of linear functions. Between two times it is therefore at
// least its chord. So boxes whose gap is positive at both times are apart throughout; if the gap is positive at one of
// the times, they are apart from there to the chord's zero. The times that several axes, each in both directions, leave
// over may have none in common. Half-way between its poses a body is the mean of both, with n the same: so chords are
// loose only by how much boxes turn, times their own size, and that is least for small boxes.
//
// The sets are those of separating_axes.hpp, with its bounds, each twice: for the poses at the start and at the end, on
// the same axes. Coordinates are relative to the first body's translation, which moves linearly, too.
// Claim: verify/proofs/motion_chords.md
#pragma once

#include <array>
#include <cstdint>

#include "bvh/axes/separating_axes.hpp"

namespace ecods {

// A tree and the linear parts of the two poses that it moves between, by reference.
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

// Returns a mask of the pairs of lanes that may meet at a time up to `limit`, in the layout of overlap_mask, and sets
// for each of them a lower bound of the time at which they meet, which is not negative.
template <class X, class Y>
std::uint64_t meeting_mask(const std::array<MotionSet, 2>& sets, float limit, const X& x, const Y& y,
                           LaneBounds& times) noexcept;

}  // namespace ecods
