// The leaves of a posed tree that come near a box of the world: what a segment within that box may hit, so that one
// after the other can be asked without a walk.
//
// A segment is that from A to B on the axes of line_axes.hpp, in floats, each coordinate off by less than `error`,
// where 64 v are of floats, v = 2^-23, and the rest is E. It is apart from a leaf whose box ends before it on an axis;
// whose slab has both ends on one side; and from a triangle whose corners end before it on an axis, or lie with it on
// two sides of some plane, for which the plane of the corners is taken.
//
// Bound. Coordinates A and B are at most 4, those of the tree 1 + 2^-21. Along an axis, the middle and the half of A
// and B are off by 4 v each for A and B and 4 v for a sum, their difference from a box and the sum of halves by 5 v and
// 6 v: with E below `error`. With a vector n of any floats, |n| the sum of its sizes and corners c off by corner_error
// < 2.01 v: n . (A - c) is off by |n| (E + 4.01 v + 2.01 v + 5.02 v + 3.01 v 5.02), n . (c' - c) by |n| (4.02 v + 2.01
// v + 3.01 v 2.01), their difference by |n| 7.1 v: by |n| (E + 46 v) in all; |n| `error` has 64 v. A slab has no
// corners, and |n| is at most 1.8 there. Underflow is below 2^-100.
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

    // Gathers those of a tree and pose, to which the axes are bound, and returns true; or returns false, with nothing
    // gathered, where the axes do not say which or they are too many. `box_tests` is made greater by the nodes looked
    // at.
    bool gather(const MeshBvh& tree, const LineAxes& axes, const Vec3& low, const Vec3& high,
                std::uint64_t& box_tests) noexcept;
    void clear() noexcept { is_ready_ = false; }
    bool is_ready() const noexcept { return is_ready_; }

    // Whether the segment is within the box of the leaves that are gathered.
    bool holds(const Vec3& a, const Vec3& b) const noexcept {
        if (!is_ready_) return false;
        for (int k = 0; k < 3; ++k) {
            if (!(a[k] >= low_[k] && a[k] <= high_[k] && b[k] >= low_[k] && b[k] <= high_[k])) return false;
        }
        return true;
    }

    // The triangles that a segment may share a point with, which must be within the box; tree, pose and axes must be
    // those of gather(). `tested` is made greater by the triangles looked at. What is returned lasts until the next
    // call.
    std::span<const std::uint32_t> find(const MeshBvh& tree, const LineAxes& axes, const Vec3& a, const Vec3& b,
                                        std::uint64_t& tested) noexcept;

  private:
    // Eight leaves and their boxes.
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
