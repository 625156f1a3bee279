// MotionAxes bounds the times at which nodes of two trees may meet while both bodies move on straight lines from one
// pose to another.
//
// For a fixed axis n the gap between two boxes (or triangles), min n . q - max n . p, is a concave function of time:
// each corner moves linearly, so the minimum is concave and the maximum convex. Between two times the gap is therefore
// at least its chord. So boxes whose gap is positive at both times are apart at all times between. If the gap is
// positive at only one of the times, the boxes are apart from that time to the chord's zero. Several axes, each in both
// directions, may leave no time at which the boxes can meet. Half-way between its poses a body is the mean of both, on
// the same axes. So a chord is loose only by the angle by which a box turns times the size of the box, which is little
// for small boxes. All of this also holds for a mesh that deforms, whose corners move linearly: a node then has a box
// at the start and another one at the end (NodeAtEnds).
//
// The sets of axes and their bounds are as in separating_axes.hpp. Each set exists twice, with the same axes: for the
// poses at the start and at the end. Coordinates are relative to the first body's translation, which moves linearly,
// too.
//
// Margins. Bodies may be only near such motions: their distance from them is a margin in the world (MotionMargin). On
// an axis n, a margin in any direction is |n| times as large; |n| as computed is off by 2.5 u' of itself. A margin
// perpendicular to a unit vector e is |n x e| times as large: a coordinate of the product is off by 2.1 u' |n|, and e
// by 5.01 u' of itself, so the length is off by less than 13 u' |n|. A margin along a vector m is |n.m| on the axis,
// which is off by 3.1 u' |n| |m|. 16 u' |n| and 8 u' |n| |m| are added. 1 + 2^-22 covers the other roundings, and the
// last conversion to a float.
// Claim: verify/proofs/motion_chords.md
// Claim: verify/proofs/turn_pieces.md
#pragma once

#include <array>
#include <cstdint>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/tree/moving_tree.hpp"

namespace ecods {

// Refers to the frames of a tree at both ends of its motion, and to the linear parts of its poses there. Only a mesh
// that deforms has two frames.
struct MovingTree {
    MovingTree(const MeshBvh& rigid, const Mat3& start, const Mat3& end) noexcept
        : MovingTree(TreeAtEnds(rigid), start, end) {}
    MovingTree(const TreeAtEnds& tree, const Mat3& start, const Mat3& end) noexcept
        : frame_from(tree.start().frame), frame_to(tree.end().frame), from(start), to(end) {}

    bool is_bounded() const noexcept { return frame_from.is_bounded && frame_to.is_bounded; }

    const LocalFrame &frame_from, &frame_to;
    const Mat3& from;
    const Mat3& to;
};

// Holds the trees on three axes, at the start and at the end of the motion.
struct MotionSet {
    AxisSet start, end;
};

// Bounds how far points of two bodies are from straight motions. The distance is a sum of vectors: one of length at
// most `everywhere`, one of length at most `most` perpendicular to each of two unit vectors, `along` times a number
// from -1 to 1, and one of length at most `later` times the part of the motion that is over.
struct MotionMargin {
    struct Across {
        double most = 0;
        Vec3 axis = Vec3::Zero();
    };

    double everywhere = 0;
    double later = 0;
    std::array<Across, 2> across{};
    Vec3 along = Vec3::Zero();
};

class MotionAxes {
  public:
    // Binds two moving trees. d_from and d_to are fl(t_b - t_a) at the start and at the end.
    void bind(const MovingTree& a, const MovingTree& b, const Vec3& d_from, const Vec3& d_to);
    // Binds two trees whose bodies are at all times within a margin of straight motions. The margin enlarges the boxes
    // of b.
    void bind(const MovingTree& a, const MovingTree& b, const Vec3& d_from, const Vec3& d_to,
              const MotionMargin& margin);

    const std::array<MotionSet, 2>& sets() const noexcept { return sets_; }

  private:
    void set_unbounded() noexcept;

    std::array<MotionSet, 2> sets_;
};

// Returns a mask of the pairs of lanes that may meet at a time up to `limit`; bit 8 j + i is for lane i of x and lane j
// of y, which are NodeAtEnds. Sets `times` to lower bounds, not negative, of the times at which these pairs meet.
template <class X, class Y>
std::uint64_t meeting_mask(const std::array<MotionSet, 2>& sets, float limit, const X& x, const Y& y,
                           LaneBounds& times) noexcept;

}  // namespace ecods
