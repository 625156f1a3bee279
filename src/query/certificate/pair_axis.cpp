#include "query/certificate/pair_axis.hpp"

#include <bit>
#include <cmath>
#include <type_traits>

#include "base/outward.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"

namespace ecods {

PairAxis pair_axis(const BodyAxis& a, const BodyAxis& b, double need) noexcept {
    constexpr double v = 0x1p-23;
    double sum = std::abs(b.q - a.q) + need;
    for (std::size_t k = 0; k < 3; ++k) sum += std::abs(a.p[k]) + std::abs(b.p[k]);
    if (!a.is_bounded || !b.is_bounded || !(sum > 0x1p-900 && sum < 0x1p900)) return {};
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(sum) >> 52;
    const double scale = std::bit_cast<double>((2 * 1023 - exponent) << 52);
    PairAxis axis;
    axis.scale = scale;
    for (std::size_t k = 0; k < 3; ++k) {
        axis.a[k] = static_cast<float>(a.p[k] * scale);
        axis.b[k] = static_cast<float>(b.p[k] * scale);
    }
    // The difference of q is rounded, too, and what is computed here: less than the 2^-20.
    const double errors = (a.error + b.error) + (a.corner_reach + b.corner_reach) + 16 * v * sum;
    const double margin = (need + errors * (1 + 0x1p-20)) * (scale * (1 + 0x1p-48)) + 0x1p-100;
    const double q = (b.q - a.q) * scale;
    axis.below = round_down(q - margin);
    axis.above = round_up(q + margin);
    return axis;
}

SlabEnds slab_ends(const PairAxis& axis, const BodyAxis& of_tree, const Slab& slab) noexcept {
    SlabEnds ends;
    double along = 0, square = 0, size = 0, rest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double m = static_cast<double>(slab.normal[k]);
        along += of_tree.p[k] * m;
        square += m * m;
        size += std::abs(of_tree.p[k]);
    }
    const double slope = along / square;
    for (std::size_t k = 0; k < 3; ++k) {
        const double part = of_tree.p[k] - slope * static_cast<double>(slab.normal[k]);
        rest += std::abs(part);
        ends.rest[k] = static_cast<float>(part * axis.scale);
    }
    if (!(rest <= size / 8)) return {};
    const double low = slope * axis.scale * static_cast<double>(slope > 0 ? slab.low : slab.high),
                 high = slope * axis.scale * static_cast<double>(slope > 0 ? slab.high : slab.low);
    ends.low = round_down(low);
    ends.high = round_up(high);
    return ends;
}

namespace {

template <std::size_t width>
struct Kernel : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::collect, Lanes::find_ends, Lanes::load, Lanes::part_count, Lanes::store;
    using typename Lanes::Floats, typename Lanes::Ints;

    struct Ends {
        alignas(32) FloatLanes low;
        alignas(32) FloatLanes high;
    };

    template <class X>
    ECODS_ALWAYS_INLINE static void project(const std::array<float, 3>& p, const X& x, const SlabEnds* slab,
                                            Ends& ends) noexcept {
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats low, high;
            find_ends(x, p, part, low, high);
            if (std::is_same_v<X, BvhNode> && slab != nullptr) {
                Floats low_rest, high_rest;
                find_ends(x, slab->rest, part, low_rest, high_rest);
                low = max(low, low_rest + slab->low);
                high = min(high, high_rest + slab->high);
            }
            store(ends.low, part, low);
            store(ends.high, part, high);
        }
    }

    template <class X, class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t apart(const PairAxis& axis, const X& x, const Y& y, std::uint32_t columns,
                                                   const SlabEnds* slab_x, const SlabEnds* slab_y) noexcept {
        Ends of_x, of_y;
        project(axis.a, x, slab_x, of_x);
        project(axis.b, y, slab_y, of_y);
        if constexpr (std::is_same_v<X, TreeLeaf> && !std::is_same_v<Y, TreeLeaf>) join_lanes(of_x);
        if constexpr (std::is_same_v<Y, TreeLeaf> && !std::is_same_v<X, TreeLeaf>) join_lanes(of_y);
        Ints apart[part_count]{};
        for (; columns != 0; columns &= columns - 1) {
            const auto j = static_cast<std::size_t>(std::countr_zero(columns));
            const float low = of_y.low[j] + axis.below, high = of_y.high[j] + axis.above;
            for (std::size_t part = 0; part < part_count; ++part)
                apart[part] |= ((load(of_x.high, part) < low) | (load(of_x.low, part) > high)) & (1 << j);
        }
        std::uint64_t pairs = 0;
        for (std::size_t part = 0; part < part_count; ++part) collect(apart[part], part, pairs);
        return pairs;
    }
};

template <class X, class Y>
std::uint64_t widest(const PairAxis& axis, const X& x, const Y& y, std::uint32_t columns, const SlabEnds* of_x,
                     const SlabEnds* of_y) noexcept {
    return dispatch_by_width<Kernel<4>::template apart<X, Y>, Kernel<8>::template apart<X, Y>>(axis, x, y, columns,
                                                                                               of_x, of_y);
}

}  // namespace

std::uint64_t apart_mask(const PairAxis& axis, const BvhNode& x, const BvhNode& y, std::uint32_t columns,
                         const SlabEnds* of_x, const SlabEnds* of_y) noexcept {
    return widest(axis, x, y, columns, of_x, of_y);
}
std::uint64_t apart_mask(const PairAxis& axis, const BvhNode& x, const TreeLeaf& y, std::uint32_t columns,
                         const SlabEnds* of_x, const SlabEnds* of_y) noexcept {
    return widest(axis, x, y, columns, of_x, of_y);
}
std::uint64_t apart_mask(const PairAxis& axis, const TreeLeaf& x, const BvhNode& y, std::uint32_t columns,
                         const SlabEnds* of_x, const SlabEnds* of_y) noexcept {
    return widest(axis, x, y, columns, of_x, of_y);
}
std::uint64_t apart_mask(const PairAxis& axis, const TreeLeaf& x, const TreeLeaf& y, std::uint32_t columns,
                         const SlabEnds* of_x, const SlabEnds* of_y) noexcept {
    return widest(axis, x, y, columns, of_x, of_y);
}

}  // namespace ecods
