// NearLeaves holds the leaves of a posed tree that overlap a box of the world. Segments within that box are then tested
// against these leaves, without a walk for each segment.
//
// A segment goes from A to B on the axes of line_axes.hpp, in floats. Each coordinate is off by less than `error`,
// which is the sum of 64 v for the rounding of floats, v = 2^-23, and E for all other errors. The segment is apart from
// a leaf if the two are disjoint on an axis, or if both its ends are beyond the leaf's slab, on the same side. The
// segment is apart from a triangle if the two are disjoint on an axis, or if a plane with the normal of the triangle's
// corners separates the two.
//
// Bound. Coordinates of A and B are at most 4, and of the tree 1 + 2^-21. Along an axis, the middle and the half of A
// and B are off by 4 v each for A and B and 4 v for a sum, their difference from a box and the sum of halves by 5 v and
// 6 v: with E below `error`. With a vector n of any floats, |n| the sum of its magnitudes and corners c off by
// corner_error < 2.01 v: n . (A - c) is off by |n| (E + 4.01 v + 2.01 v + 5.02 v + 3.01 v 5.02), n . (c' - c) by |n|
// (4.02 v + 2.01 v + 3.01 v 2.01), their difference by |n| 7.1 v: by |n| (E + 46 v) in all; |n| `error` has 64 v. A
// slab has no corners, and |n| is at most 1.8 there. Underflow is below 2^-100.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "bvh/axes/line_axes.hpp"
#include "bvh/tree/mesh_bvh.hpp"

namespace ecods {

class NearLeaves {
  public:
    static constexpr std::size_t leaf_count_max = 64;

    // Collects the leaves that overlap the box from `low` to `high`, and returns true. Returns false, with no leaves,
    // if the axes cannot place the box or there are too many leaves. `axes` must be bound to the tree and its pose.
    // Adds the number of visited nodes to `box_tests`.
    bool gather(const MeshBvh& tree, const LineAxes& axes, const Vec3& low, const Vec3& high,
                std::uint64_t& box_tests) noexcept;
    void clear() noexcept { is_ready_ = false; }
    bool is_ready() const noexcept { return is_ready_; }

    // Returns true if leaves are collected, and the segment from a to b is within their box.
    bool holds(const Vec3& a, const Vec3& b) const noexcept {
        if (!is_ready_) return false;
        for (int k = 0; k < 3; ++k) {
            if (!(a[k] >= low_[k] && a[k] <= high_[k] && b[k] >= low_[k] && b[k] <= high_[k])) return false;
        }
        return true;
    }

    // Returns the triangles with which a segment from a to b may share a point. The segment must be within the box:
    // holds(a, b). Tree, pose and axes must be the same as in gather(). Adds the number of tested triangles to
    // `tested`. The list is valid until the next call.
    std::span<const std::uint32_t> find(const MeshBvh& tree, const LineAxes& axes, const Vec3& a, const Vec3& b,
                                        std::uint64_t& tested) noexcept;

  private:
    // Holds up to eight leaves, by index, and their boxes.
    struct alignas(32) Group {
        std::array<FloatLanes, 3> center, half;
        std::array<std::uint32_t, tree_width> leaf;
    };
    template <std::size_t width>
    struct Lanes;

    bool is_ready_ = false;
    Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
    float error_ = 0;
    std::size_t leaf_count_ = 0;
    std::array<Group, leaf_count_max / tree_width> groups_;
    std::array<std::uint32_t, leaf_count_max * tree_width> triangles_;
};

}  // namespace ecods
