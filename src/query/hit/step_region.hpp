// StepRegion serves a segment that moves in small steps: it gathers the leaves of one body near the segment's path once
// for many steps.
//
// A StepRegion saves work, and no result depends on it. A segment within the region is tested against every triangle of
// the region that the segment may hit; for any other segment the caller walks the tree.
#pragma once

#include <algorithm>
#include <cstdint>

#include "bvh/walks/near_leaves.hpp"
#include "geometry/line.hpp"

namespace ecods {

class StepRegion {
  public:
    // Deletes the region and the last segment. Call this function if the body or its pose changes.
    void forget() noexcept {
        leaves_.clear();
        has_last_ = false;
        rest_ = rest_next_ = 0;
    }

    // Returns true if the segment is within the region, and then stores the segment as the last one.
    bool holds(const Line& segment) noexcept {
        if (!leaves_.holds(segment.a, segment.b)) return false;
        ++served_;
        last_a_ = segment.a;
        last_b_ = segment.b;
        return true;
    }
    NearLeaves& leaves() noexcept { return leaves_; }

    // Stores a segment that is not within the region as the last one. If the segment has moved little since the one
    // before, gathers a new region around the segment and its path ahead. If the previous region served few segments, a
    // new region is gathered only some segments later.
    void follow(const Line& segment, const MeshBvh& tree, const LineAxes& axes, std::uint64_t& box_tests) noexcept {
        if (leaves_.is_ready()) {
            leaves_.clear();
            has_served(served_ >= served_min);
        }
        const Vec3 by_a = segment.a - last_a_, by_b = segment.b - last_b_;
        const bool had_last = has_last_;
        last_a_ = segment.a;
        last_b_ = segment.b;
        has_last_ = true;
        if (!had_last) return;
        if (rest_ > 0) {
            --rest_;
            return;
        }
        const double by = std::max(by_a.cwiseAbs().maxCoeff(), by_b.cwiseAbs().maxCoeff());
        if (!(by <= moved_max * (segment.b - segment.a).cwiseAbs().maxCoeff())) return;
        const double aside = steps_aside * by;
        const Vec3 then_a = segment.a + steps_ahead * by_a, then_b = segment.b + steps_ahead * by_b;
        const Vec3 low = segment.a.cwiseMin(segment.b).cwiseMin(then_a.cwiseMin(then_b)) - Vec3::Constant(aside);
        const Vec3 high = segment.a.cwiseMax(segment.b).cwiseMax(then_a.cwiseMax(then_b)) + Vec3::Constant(aside);
        served_ = 0;
        if (!leaves_.gather(tree, axes, low, high, box_tests)) has_served(false);
    }

  private:
    // Both numbers were chosen by measuring a path over a torus, with segments from each point to the next: any
    // steps_ahead from 16 to 32 is as good as 20.
    static constexpr double steps_ahead = 20, steps_aside = 2;
    static constexpr double moved_max = 3;  // in lengths of the segment; a greater move counts as a jump
    static constexpr std::uint32_t served_min = 4, rest_max = 63;

    void has_served(bool enough) noexcept {
        rest_next_ = enough ? 0 : std::min(2 * rest_next_ + 1, rest_max);
        rest_ = rest_next_;
    }

    NearLeaves leaves_;
    Vec3 last_a_ = Vec3::Zero(), last_b_ = Vec3::Zero();
    bool has_last_ = false;
    std::uint32_t served_ = 0;
    std::uint32_t rest_ = 0,
                  rest_next_ = 0;  // segments to wait without a region: now, and after the last region
};

}  // namespace ecods
