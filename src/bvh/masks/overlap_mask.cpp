#include <bit>
#include <type_traits>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/masks/eight_pairs.hpp"
#include "bvh/masks/flat_lanes.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "bvh/masks/triangle_lanes.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"
#include "simd/wide.hpp"

namespace ecods {
namespace {

template <std::size_t width>
struct OverlapKernel : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::bits_of, Lanes::collect, Lanes::find_ends, Lanes::find_thin_ends, Lanes::load, Lanes::part_count,
        Lanes::place;
    using typename Lanes::Corners, typename Lanes::Floats, typename Lanes::Ints, typename Lanes::SlabAxis,
        typename Lanes::Spans, typename Lanes::ThinAxis, typename Lanes::Triangles;
    using AxisSets = std::array<AxisSet, 2>;

    // Returns in lane j those bits i of `rows` for which span i of x and span j of y are not apart on any axis. NaN
    // compares false: not apart.
    ECODS_ALWAYS_INLINE static Ints find_near(const Spans& x, const Spans& y, std::size_t part,
                                              std::uint32_t rows) noexcept {
        Ints near{};
        for (; rows != 0; rows &= rows - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rows));
            Ints apart = (x.low[0][i] > load(y.high[0], part)) | (x.high[0][i] < load(y.low[0], part));
            for (std::size_t k = 1; k < 3; ++k) {
                apart |= (x.low[k][i] > load(y.high[k], part)) | (x.high[k][i] < load(y.low[k], part));
            }
            near |= ~apart & (1 << i);
        }
        return near;
    }

    // Sets the lanes of `other`, projected by `p`, that are not certainly beyond the slab of a node of the other tree.
    // `set` and `shift` as for SlabAxis.
    template <class Other>
    ECODS_ALWAYS_INLINE static void find_in_slab(const AxisSet& set, const Slab& slab, const Projection& p,
                                                 const Other& other, float shift, Ints (&lanes)[part_count]) noexcept {
        const SlabAxis axis(set, slab, p, shift);
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats low, high;
            find_ends(other, axis.m, part, low, high);
            lanes[part] = ~((low > axis.high) | (high < axis.low));
        }
    }

    // Clears the lanes of `other` whose boxes are certainly beyond the slab where `other` has one of its own that says
    // more than its boxes do. Arguments as for find_in_slab.
    ECODS_ALWAYS_INLINE static void find_thin(const AxisSet& set, const Slab& slab, const Projection& p,
                                              const BvhNode& other, float shift, Ints (&lanes)[part_count]) noexcept {
        const SlabAxis axis(set, slab, p, shift);
        const ThinAxis thin(axis, other.slab);
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats low, high;
            find_thin_ends(other, thin, part, low, high);
            lanes[part] &= ~((low > axis.high) | (high < axis.low));
        }
    }

    // Clears the bits of pairs of triangles that are proven to be apart, and returns which are proven to cross.
    ECODS_ALWAYS_INLINE static std::uint64_t find_triangles(const AxisSet& set, const Triangles& x, const Triangles& y,
                                                            Ints (&near)[part_count]) noexcept {
        if (set.flat_axis >= 0) {
            for (std::size_t part = 0; part < part_count; ++part) {
                near[part] &= FlatLanes<width>::find_near_edges(set, x.corners, x.spans, y.corners, y.spans, part,
                                                                rows_of(near[part]));
            }
            return 0;
        }
        const typename TriangleLanes<width>::Normals normals(x.corners);
        std::uint64_t crossing = 0;
        for (std::size_t part = 0; part < part_count; ++part) {
            const auto found = TriangleLanes<width>::find(set.point_error, x.corners, x.spans, normals, y.corners,
                                                          y.spans, part, near[part], rows_of(near[part]));
            near[part] = found.near;
            collect(found.crossing, part, crossing);
        }
        return set.is_bijective ? crossing : 0;
    }
    ECODS_ALWAYS_INLINE static std::uint32_t rows_of(const Ints& near) noexcept {
        return static_cast<std::uint32_t>(any_bits(near));
    }

    // Nothing crosses but triangles of two leaves.
    template <class X, class Y>
    ECODS_ALWAYS_INLINE static TrianglePairs find(const AxisSets& sets, const X& x, const Y& y) noexcept {
        // Slabs first: they separate most pairs whose boxes overlap, nearly flat parts of smooth surfaces above each
        // other.
        Ints near[part_count], lanes[part_count];
        std::uint32_t rows = x.lanes();
        if (sets[0].a.is_unit) {
            find_in_slab(sets[0], x.slab, sets[0].b, y, 1, near);
            if (bits_of(near) == 0) return {};
        } else {
            for (Ints& all : near) all = ~Ints{};
        }
        if (sets[1].b.is_unit) {
            find_in_slab(sets[1], y.slab, sets[1].a, x, -1, lanes);
            for (std::size_t part = 0; part < part_count; ++part)
                lanes[part] &= lane_bits<Ints>(static_cast<int>(part * width));
            rows &= bits_of(lanes);
            if (rows == 0) return {};
        }
        if constexpr (std::is_same_v<Y, BvhNode>) {
            if (sets[0].a.is_unit && y.is_thin) {
                find_thin(sets[0], x.slab, sets[0].b, y, 1, near);
                if (bits_of(near) == 0) return {};
            }
        }
        if constexpr (std::is_same_v<X, BvhNode>) {
            if (sets[1].b.is_unit && x.is_thin) {
                find_thin(sets[1], y.slab, sets[1].a, x, -1, lanes);
                rows &= bits_of(lanes);
                if (rows == 0) return {};
            }
        }

        Corners corners_x, corners_y, other;
        Spans spans_x, spans_y, other_x, other_y;
        place(sets[0].a, x, corners_x, spans_x);
        place(sets[0].b, y, corners_y, spans_y);
        for (std::size_t part = 0; part < part_count; ++part) near[part] &= find_near(spans_x, spans_y, part, rows);
        rows = bits_of(near);
        if (rows == 0) return {};

        place(sets[1].a, x, other, other_x);
        place(sets[1].b, y, other, other_y);
        for (std::size_t part = 0; part < part_count; ++part) near[part] &= find_near(other_x, other_y, part, rows);
        if (bits_of(near) == 0) return {};

        const std::uint64_t lanes_of_y = ~std::uint64_t{0} >> (64 - tree_width * y.count);
        std::uint64_t pairs = 0, crossing = 0;
        if constexpr (std::is_same_v<X, TreeLeaf> && std::is_same_v<Y, TreeLeaf>) {
            crossing = find_triangles(sets[0], {corners_x, spans_x}, {corners_y, spans_y}, near);
        }
        for (std::size_t part = 0; part < part_count; ++part) collect(near[part], part, pairs);
        return {pairs & lanes_of_y, crossing & lanes_of_y};
    }
};

#if ECODS_CAN_DISPATCH
// Two rows of pairs at once: masks of sixteen bits are two bytes of the answer. What has no pairs is that of the
// others.
struct WideKernel : OverlapKernel<8> {
    // Returns those of `pairs` whose spans are not apart on any axis.
    ECODS_WIDE_INLINE static std::uint64_t find_near(const Spans& x, const Spans& y, std::uint64_t pairs) noexcept {
        const wide::Floats x_low[3] = {twice(x.low[0]), twice(x.low[1]), twice(x.low[2])},
                           x_high[3] = {twice(x.high[0]), twice(x.high[1]), twice(x.high[2])},
                           y_low[3] = {twice(y.low[0]), twice(y.low[1]), twice(y.low[2])},
                           y_high[3] = {twice(y.high[0]), twice(y.high[1]), twice(y.high[2])};
        return near_two<0>(x_low, x_high, y_low, y_high, pairs) | near_two<2>(x_low, x_high, y_low, y_high, pairs) |
               near_two<4>(x_low, x_high, y_low, y_high, pairs) | near_two<6>(x_low, x_high, y_low, y_high, pairs);
    }

    // As OverlapKernel::find_in_slab, as bits.
    template <class Other>
    ECODS_WIDE_INLINE static std::uint32_t in_slab(const AxisSet& set, const Slab& slab, const Projection& p,
                                                   const Other& other, float shift) noexcept {
        const SlabAxis axis(set, slab, p, shift);
        Floats low, high;
        find_ends(other, axis.m, 0, low, high);
        return wide::not_outside(low, high, axis.low, axis.high);
    }

    // As OverlapKernel::find_thin, as bits.
    ECODS_WIDE_INLINE static std::uint32_t in_thin(const AxisSet& set, const Slab& slab, const Projection& p,
                                                   const BvhNode& other, float shift) noexcept {
        const SlabAxis axis(set, slab, p, shift);
        Floats low, high;
        find_thin_ends(other, ThinAxis(axis, other.slab), 0, low, high);
        return wide::not_outside(low, high, axis.low, axis.high);
    }

    // As OverlapKernel::find.
    template <class X, class Y>
    ECODS_WIDE static TrianglePairs find(const AxisSets& sets, const X& x, const Y& y) noexcept {
        std::uint64_t pairs = ~std::uint64_t{0} >> (64 - tree_width * y.count);
        if (sets[0].a.is_unit) {
            pairs &= wide::bytes_of(in_slab(sets[0], x.slab, sets[0].b, y, 1));
            if (pairs == 0) return {};
        }
        std::uint32_t lanes_of_x = x.lanes();
        if (sets[1].b.is_unit) {
            lanes_of_x &= in_slab(sets[1], y.slab, sets[1].a, x, -1);
            if (lanes_of_x == 0) return {};
        }
        pairs &= wide::in_each_byte(lanes_of_x);
        if constexpr (std::is_same_v<Y, BvhNode>) {
            if (sets[0].a.is_unit && y.is_thin) {
                pairs &= wide::bytes_of(in_thin(sets[0], x.slab, sets[0].b, y, 1));
                if (pairs == 0) return {};
            }
        }
        if constexpr (std::is_same_v<X, BvhNode>) {
            if (sets[1].b.is_unit && x.is_thin) {
                pairs &= wide::in_each_byte(in_thin(sets[1], y.slab, sets[1].a, x, -1));
                if (pairs == 0) return {};
            }
        }

        Corners corners_x, corners_y, other;
        Spans spans_x, spans_y, other_x, other_y;
        place(sets[0].a, x, corners_x, spans_x);
        place(sets[0].b, y, corners_y, spans_y);
        pairs = find_near(spans_x, spans_y, pairs);
        if (pairs == 0) return {};
        place(sets[1].a, x, other, other_x);
        place(sets[1].b, y, other, other_y);
        pairs = find_near(other_x, other_y, pairs);
        if (pairs == 0) return {};

        std::uint64_t crossing = 0;
        if constexpr (std::is_same_v<X, TreeLeaf> && std::is_same_v<Y, TreeLeaf>) {
            crossing = EightPairs::find(sets[0], {corners_x, spans_x}, {corners_y, spans_y}, pairs);
        }
        return {pairs, crossing};
    }

  private:
    ECODS_WIDE_INLINE static wide::Floats twice(const FloatLanes& lanes) noexcept { return wide::twice(lanes.data()); }

    // Of lanes j and j + 1 of y.
    template <int j>
    ECODS_WIDE_INLINE static std::uint64_t near_two(const wide::Floats (&x_low)[3], const wide::Floats (&x_high)[3],
                                                    const wide::Floats (&y_low)[3], const wide::Floats (&y_high)[3],
                                                    std::uint64_t pairs) noexcept {
        // A comparison waits for the mask of the one before it: two chains take half as long as one, and more are no
        // faster.
        auto begin = static_cast<wide::Mask>(pairs >> (8 * j));
        wide::Mask end = wide::all;
        for (std::size_t k = 0; k < 3; ++k) {
            begin = wide::not_above(begin, x_low[k], wide::two_of<j>(y_high[k]));
            end = wide::not_below(end, x_high[k], wide::two_of<j>(y_low[k]));
        }
        return static_cast<std::uint64_t>(begin & end) << (8 * j);
    }
};
#endif

using AxisSets = std::array<AxisSet, 2>;

template <class X, class Y>
TrianglePairs widest(const AxisSets& sets, const X& x, const Y& y) noexcept {
#if ECODS_CAN_DISPATCH
    return dispatch_by_three_widths<OverlapKernel<4>::find<X, Y>, OverlapKernel<8>::find<X, Y>, WideKernel::find<X, Y>>(
        sets, x, y);
#else
    return dispatch_by_width<OverlapKernel<4>::find<X, Y>, OverlapKernel<8>::find<X, Y>>(sets, x, y);
#endif
}

}  // namespace

std::uint64_t overlap_mask(const AxisSets& sets, const BvhNode& x, const BvhNode& y) noexcept {
    return widest(sets, x, y).near;
}
std::uint64_t overlap_mask(const AxisSets& sets, const BvhNode& x, const TreeLeaf& y) noexcept {
    return widest(sets, x, y).near;
}
std::uint64_t overlap_mask(const AxisSets& sets, const TreeLeaf& x, const BvhNode& y) noexcept {
    return widest(sets, x, y).near;
}
std::uint64_t overlap_mask(const AxisSets& sets, const TreeLeaf& x, const TreeLeaf& y) noexcept {
    return widest(sets, x, y).near;
}
TrianglePairs triangle_pairs(const AxisSets& sets, const TreeLeaf& x, const TreeLeaf& y) noexcept {
    return widest(sets, x, y);
}

}  // namespace ecods
