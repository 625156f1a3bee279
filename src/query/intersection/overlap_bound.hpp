// Defines the bound of walks of two trees that search for common points.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/walks/walk_two.hpp"
#include "ecods/intersection.hpp"

namespace ecods {

// An OverlapBound makes a walk of two trees skip the pairs of boxes and of triangles that an axis or a plane certainly
// separates.
class OverlapBound {
  public:
    OverlapBound(const std::array<AxisSet, 2>& sets, QueryCounts& counts) : sets_(sets), counts_(counts) {}

    template <class X, class Y>
    std::uint64_t operator()(const X& x, const Y& y) {
        ++counts_.box_tests;
        return overlap_mask(sets_, x, y);
    }

    TrianglePairs triangle_pairs(const TreeLeaf& x, const TreeLeaf& y) {
        ++counts_.box_tests;
        return ecods::triangle_pairs(sets_, x, y);
    }

    // If at least four pairs of children overlap, moves the pair with the nearest centers to the end of `children`,
    // from where the walk takes the next pair. If bodies overlap deeply, the pair with the nearest centers nearly
    // always intersects. Only the order of the walk depends on order().
    void order(const BvhNode& x, const BvhNode& y, LanePairs pairs, std::span<NodePair> children) const {
        constexpr std::size_t crowd_min = 4;
        if (children.size() < crowd_min) return;
        const Projection& p = sets_[0].b;
        std::array<FloatLanes, 3> middle;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t j = 0; j < tree_width; ++j) {
                middle[k][j] =
                    ((p.p[0][k] * y.center[0][j] + p.p[1][k] * y.center[1][j]) + p.p[2][k] * y.center[2][j]) +
                    p.shift[k];
            }
        }
        std::size_t at = 0, closest = 0;
        float least = std::numeric_limits<float>::infinity();
        for (; pairs.more(); pairs.next(), ++at) {
            float distance = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const float d = x.center[k][pairs.i()] - middle[k][pairs.j()];
                distance += d * d;
            }
            if (distance < least) {
                least = distance;
                closest = at;
            }
        }
        std::swap(children[closest], children.back());
    }

  private:
    const std::array<AxisSet, 2>& sets_;
    QueryCounts& counts_;
};

}  // namespace ecods
