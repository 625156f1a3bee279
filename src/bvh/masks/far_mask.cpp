#include "bvh/axes/far_gap.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

template <std::size_t width>
struct FarKernel : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::collect, Lanes::find_ends, Lanes::part_count;
    using typename Lanes::Floats, typename Lanes::Ints;

    template <class X, class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t far_mask(const FarGap& gap, float limit, const X& x, const Y& y,
                                                      LaneSquares& ranks) noexcept {
        alignas(32) FloatLanes high_x;
        Floats low[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats unused, high;
            find_ends(x, gap.a, part, unused, high);
            Lanes::store(high_x, part, high);
            find_ends(y, gap.b, part, low[part], unused);
        }
        std::uint64_t pairs = 0;
        for (std::size_t part = 0; part < part_count; ++part) {
            Ints near{};
            for (std::size_t i = 0; i < x.count; ++i) {
                const Floats rank = max((low[part] - high_x[i]) + gap.reach, Floats{});
                ecods::store(&ranks[tree_width * i + part * width], rank);
                near |= (rank <= limit) & (1 << i);
            }
            collect(near, part, pairs);
        }
        return pairs & ~std::uint64_t{0} >> (64 - tree_width * y.count);
    }
};

template <class X, class Y>
std::uint64_t widest(const FarGap& gap, float limit, const X& x, const Y& y, LaneSquares& ranks) noexcept {
    return dispatch_by_width<FarKernel<4>::far_mask<X, Y>, FarKernel<8>::far_mask<X, Y>>(gap, limit, x, y, ranks);
}

}  // namespace

std::uint64_t far_mask(const FarGap& gap, float limit, const BvhNode& x, const BvhNode& y,
                       LaneSquares& ranks) noexcept {
    return widest(gap, limit, x, y, ranks);
}
std::uint64_t far_mask(const FarGap& gap, float limit, const BvhNode& x, const TreeLeaf& y,
                       LaneSquares& ranks) noexcept {
    return widest(gap, limit, x, y, ranks);
}
std::uint64_t far_mask(const FarGap& gap, float limit, const TreeLeaf& x, const BvhNode& y,
                       LaneSquares& ranks) noexcept {
    return widest(gap, limit, x, y, ranks);
}
std::uint64_t far_mask(const FarGap& gap, float limit, const TreeLeaf& x, const TreeLeaf& y,
                       LaneSquares& ranks) noexcept {
    return widest(gap, limit, x, y, ranks);
}

}  // namespace ecods
