#include "bvh/walks/near_leaves.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "bvh/masks/projected_lanes.hpp"
#include "bvh/walks/tree_view.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

constexpr std::size_t stack_size = 64;

// Holds a segment from a to b, in coordinates along the tree's axes.
struct SegmentOnAxes {
    std::array<float, 3> a, b;
    std::array<float, 3> low, high, middle, reach;  // its box, including the error
    float error;
};

}  // namespace

template <std::size_t width>
struct NearLeaves::Lanes : ProjectedLanes<width> {
    using Base = ProjectedLanes<width>;
    using Base::bits_of, Base::load, Base::part_count;
    using typename Base::Floats, typename Base::Ints;

    // Returns a mask of the lanes whose boxes overlap the box with the center `middle` and the half size `reach`.
    ECODS_ALWAYS_INLINE static std::uint32_t meet(const std::array<FloatLanes, 3>& center,
                                                  const std::array<FloatLanes, 3>& half,
                                                  const std::array<float, 3>& middle,
                                                  const std::array<float, 3>& reach) noexcept {
        Ints lanes[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            Ints apart{};
            for (std::size_t k = 0; k < 3; ++k) {
                apart |= absolute(load(center[k], part) - middle[k]) > load(half[k], part) + reach[k];
            }
            lanes[part] = ~apart & lane_bits<Ints>(static_cast<int>(part * width));
        }
        return bits_of(lanes);
    }

    // Adds `leaf` to the list `to`. box(k) returns the center and the half size of its box on axis k.
    template <class Box>
    ECODS_ALWAYS_INLINE static void add(NearLeaves& to, TreeRef leaf, const Box& box) noexcept {
        Group& group = to.groups_[to.leaf_count_ / tree_width];
        const std::size_t at = to.leaf_count_++ % tree_width;
        for (std::size_t k = 0; k < 3; ++k) std::tie(group.center[k][at], group.half[k][at]) = box(k);
        group.leaf[at] = leaf.index();
    }

    ECODS_ALWAYS_INLINE static void gather(const MeshBvh& tree, const BoxOnAxes& box, NearLeaves& result,
                                           std::uint64_t& box_tests) noexcept {
        result.leaf_count_ = 0;
        result.is_ready_ = true;
        if (tree.root.is_leaf()) {
            add(result, tree.root, [&](std::size_t k) { return std::pair(tree.root_center[k], tree.root_half[k]); });
            return;
        }
        FixedStack<TreeRef, stack_size> stack;
        // Adds a node's leaves to the list, because the node holds their boxes, and returns the other children to be
        // visited. Sets is_ready_ to false, which ends the walk, if there are too many leaves or too many nodes that
        // wait.
        const auto bound = [&](TreeRef ref) -> std::uint32_t {
            if (!result.is_ready_) return 0;
            const BvhNode& node = tree.nodes[ref.index()];
            ++box_tests;
            std::uint32_t inner = meet(node.center, node.half, box.center, box.half) & node.lanes();
            for (std::uint32_t lanes = inner; lanes != 0; lanes &= lanes - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
                if (!node.child[lane].is_leaf()) continue;
                inner ^= lanes & -lanes;
                result.is_ready_ &= result.leaf_count_ < leaf_count_max;
                if (!result.is_ready_) return 0;
                add(result, node.child[lane],
                    [&](std::size_t k) { return std::pair(node.center[k][lane], node.half[k][lane]); });
            }
            result.is_ready_ = stack.size() + static_cast<std::size_t>(std::popcount(inner)) <= stack_size;
            return result.is_ready_ ? inner : 0;
        };
        walk_one(TreeView(tree), stack, bound, [](TreeRef, std::uint32_t) { return true; });
    }

    ECODS_ALWAYS_INLINE static std::uint32_t find_triangles(const TreeLeaf& leaf, const SegmentOnAxes& s) noexcept {
        Ints lanes[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats u[3], v[3], a[3], b[3];
            Ints apart{};
            for (std::size_t k = 0; k < 3; ++k) {
                const Floats p = load(leaf.corner[0][k], part), q = load(leaf.corner[1][k], part),
                             r = load(leaf.corner[2][k], part);
                apart |= (min(p, min(q, r)) > s.high[k]) | (max(p, max(q, r)) < s.low[k]);
                u[k] = q - p;
                v[k] = r - p;
                a[k] = s.a[k] - p;
                b[k] = s.b[k] - p;
            }
            const Floats n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
            const auto along_n = [&](const Floats(&w)[3]) ECODS_INLINE_LAMBDA -> Floats {
                return (n[0] * w[0] + n[1] * w[1]) + n[2] * w[2];
            };
            const Floats of_u = along_n(u), of_v = along_n(v), of_a = along_n(a), of_b = along_n(b), zero{};
            const Floats size = (absolute(n[0]) + absolute(n[1])) + absolute(n[2]);
            const Floats error = (s.error * (1 + 0x1p-10f)) * size + 0x1p-100f;
            apart |= (min(of_a, of_b) - max(zero, max(of_u, of_v)) > error) |
                     (min(zero, min(of_u, of_v)) - max(of_a, of_b) > error);
            lanes[part] = ~apart & lane_bits<Ints>(static_cast<int>(part * width));
        }
        return bits_of(lanes) & leaf.lanes();
    }

    ECODS_ALWAYS_INLINE static bool is_off_slab(const Slab& slab, const SegmentOnAxes& s) noexcept {
        const auto& n = slab.normal;
        const float a = (n[0] * s.a[0] + n[1] * s.a[1]) + n[2] * s.a[2];
        const float b = (n[0] * s.b[0] + n[1] * s.b[1]) + n[2] * s.b[2];
        const float error = 2 * s.error;
        return std::min(a, b) - slab.high > error || slab.low - std::max(a, b) > error;
    }

    // Sets near.triangles_ to the triangles that may meet the segment, and returns their number.
    ECODS_ALWAYS_INLINE static std::size_t find(const MeshBvh& tree, const SegmentOnAxes& s, NearLeaves& near,
                                                std::uint64_t& tested) noexcept {
        std::size_t count = 0;
        for (std::size_t first = 0; first < near.leaf_count_; first += tree_width) {
            const Group& group = near.groups_[first / tree_width];
            std::uint32_t lanes = meet(group.center, group.half, s.middle, s.reach);
            if (near.leaf_count_ - first < tree_width) lanes &= (1u << (near.leaf_count_ - first)) - 1;
            for (; lanes != 0; lanes &= lanes - 1) {
                const TreeLeaf& leaf = tree.leaves[group.leaf[static_cast<std::size_t>(std::countr_zero(lanes))]];
                if (is_off_slab(leaf.slab, s)) continue;
                tested += leaf.count;
                for (std::uint32_t found = find_triangles(leaf, s); found != 0; found &= found - 1) {
                    near.triangles_[count++] = leaf.triangle[static_cast<std::size_t>(std::countr_zero(found))];
                }
            }
        }
        return count;
    }
};

bool NearLeaves::gather(const MeshBvh& tree, const LineAxes& axes, const Vec3& low, const Vec3& high,
                        std::uint64_t& box_tests) noexcept {
    is_ready_ = false;
    BoxOnAxes box;
    if (!axes.place_box(low, high, box)) return false;
    low_ = low;
    high_ = high;
    error_ = box.error;
    dispatch_by_width<Lanes<4>::gather, Lanes<8>::gather>(tree, box, *this, box_tests);
    return is_ready_;
}

std::span<const std::uint32_t> NearLeaves::find(const MeshBvh& tree, const LineAxes& axes, const Vec3& a, const Vec3& b,
                                                std::uint64_t& tested) noexcept {
    SegmentOnAxes s{axes.at(a), axes.at(b), {}, {}, {}, {}, error_};
    for (std::size_t k = 0; k < 3; ++k) {
        s.low[k] = std::min(s.a[k], s.b[k]) - error_;
        s.high[k] = std::max(s.a[k], s.b[k]) + error_;
        s.middle[k] = 0.5f * (s.a[k] + s.b[k]);
        s.reach[k] = 0.5f * std::abs(s.a[k] - s.b[k]) + error_;
    }
    const std::size_t count = dispatch_by_width<Lanes<4>::find, Lanes<8>::find>(tree, s, *this, tested);
    return std::span(triangles_).first(count);
}

}  // namespace ecods
