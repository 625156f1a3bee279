#include <limits>

#include "bvh/axes/distance_axes.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

template <std::size_t width>
struct NearestKernel : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::load, Lanes::part_count, Lanes::place;
    using typename Lanes::Corners, typename Lanes::Floats, typename Lanes::Spans;

    // Gaps count more than the distance of centers, which decides among boxes that overlap.
    template <class X, class Y>
    ECODS_ALWAYS_INLINE static LanePair find(const DistanceSet& set, const X& x, const Y& y) noexcept {
        Corners corners;
        Spans spans_x, spans_y;
        place(set.axes.a, x, corners, spans_x);
        place(set.axes.b, y, corners, spans_y);
        LanePair best{0, 0};
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < x.count; ++i) {
            alignas(32) std::array<float, tree_width> sums;
            for (std::size_t part = 0; part < part_count; ++part) {
                Floats sum{};
                for (std::size_t k = 0; k < 3; ++k) {
                    const Floats low = load(spans_y.low[k], part), high = load(spans_y.high[k], part);
                    const Floats gap = max(max(spans_x.low[k][i] - high, low - spans_x.high[k][i]), Floats{});
                    const Floats twice = (low + high) - (spans_x.low[k][i] + spans_x.high[k][i]);
                    sum = sum + (16 * (gap * gap) + twice * twice);
                }
                ecods::store(&sums[part * width], sum);
            }
            for (std::size_t j = 0; j < y.count; ++j) {
                if (!(sums[j] < least)) continue;
                least = sums[j];
                best = {i, j};
            }
        }
        return best;
    }
};

template <class X, class Y>
LanePair widest(const DistanceSet& set, const X& x, const Y& y) noexcept {
    return dispatch_by_width<NearestKernel<4>::find<X, Y>, NearestKernel<8>::find<X, Y>>(set, x, y);
}

}  // namespace

LanePair nearest_lanes(const DistanceSet& set, const BvhNode& x, const BvhNode& y) noexcept {
    return widest(set, x, y);
}
LanePair nearest_lanes(const DistanceSet& set, const BvhNode& x, const TreeLeaf& y) noexcept {
    return widest(set, x, y);
}
LanePair nearest_lanes(const DistanceSet& set, const TreeLeaf& x, const BvhNode& y) noexcept {
    return widest(set, x, y);
}
LanePair nearest_lanes(const DistanceSet& set, const TreeLeaf& x, const TreeLeaf& y) noexcept {
    return widest(set, x, y);
}

}  // namespace ecods
