#include <bit>
#include <cmath>
#include <type_traits>

#include "bvh/flat_lanes.hpp"
#include "bvh/projected_lanes.hpp"
#include "bvh/separating_axes.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

template <std::size_t width>
struct Kernel : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::bits_of, Lanes::collect, Lanes::find_ends, Lanes::load, Lanes::part_count, Lanes::place;
    using typename Lanes::Corners, typename Lanes::Floats, typename Lanes::Ints, typename Lanes::SlabAxis,
        typename Lanes::Spans;
    using Sets = std::array<AxisSet, 2>;

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

    template <class X, class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t overlap_mask(const Sets& sets, const X& x, const Y& y) noexcept {
        // Slabs first: they separate most pairs whose boxes overlap, nearly flat parts of smooth surfaces above each
        // other.
        Ints near[part_count], lanes[part_count];
        std::uint32_t rows = x.lanes();
        if (sets[0].a.is_unit) {
            find_in_slab(sets[0], x.slab, sets[0].b, y, 1, near);
            if (bits_of(near) == 0) return 0;
        } else {
            for (Ints& all : near) all = ~Ints{};
        }
        if (sets[1].b.is_unit) {
            find_in_slab(sets[1], y.slab, sets[1].a, x, -1, lanes);
            for (std::size_t part = 0; part < part_count; ++part)
                lanes[part] &= lane_bits<Ints>(static_cast<int>(part * width));
            rows &= bits_of(lanes);
            if (rows == 0) return 0;
        }

        Corners corners_x, corners_y, other;
        Spans spans_x, spans_y, other_x, other_y;
        place(sets[0].a, x, corners_x, spans_x);
        place(sets[0].b, y, corners_y, spans_y);
        for (std::size_t part = 0; part < part_count; ++part) near[part] &= find_near(spans_x, spans_y, part, rows);
        rows = bits_of(near);
        if (rows == 0) return 0;

        place(sets[1].a, x, other, other_x);
        place(sets[1].b, y, other, other_y);
        for (std::size_t part = 0; part < part_count; ++part) near[part] &= find_near(other_x, other_y, part, rows);
        rows = bits_of(near);
        if (rows == 0) return 0;

        std::uint64_t pairs = 0;
        for (std::size_t part = 0; part < part_count; ++part) {
            if constexpr (std::is_same_v<X, TreeLeaf> && std::is_same_v<Y, TreeLeaf>) {
                near[part] &=
                    sets[0].flat_axis >= 0
                        ? FlatLanes<width>::find_near_edges(sets[0], corners_x, spans_x, corners_y, spans_y, part, rows)
                        : find_near_planes(sets[0].point_error, corners_x, spans_x, corners_y, spans_y, part, rows);
            }
            collect(near[part], part, pairs);
        }
        return pairs & ~std::uint64_t{0} >> (64 - tree_width * y.count);
    }

    // Returns in lane j those bits i of `rows` for which neither plane is proven to separate triangle i of x from
    // triangle j of y, by having all corners of the other triangle strictly on one side. Coordinates are the world's
    // under one linear map, so triangles separated there are disjoint in the world.
    //
    // Bound: that of exact/sign/filter_bound.hpp, whose derivation holds for any unit roundoff, with v = 2^-23 for u'
    // and point_error for delta. With E the extents of the two triangles, enlarged by e = v E + 2 delta, it is
    //     (30 v ExEyEz + 6 (ex Ey Ez + Ex ey Ez + Ex Ey ez)) (1 + 2^-10)
    //   = (48 v ExEyEz + 12 (dx Ey Ez + Ex dy Ez + Ex Ey dz)) (1 + 2^-10),    d = delta;
    // 49 and 12.5 cover the last factor and their own evaluation. Overflow: not for extents below 2^40, and others are
    // not judged. (An infinity would be harmless, but a mode that rounds down turns only the determinants into one, and
    // the bound into the largest float.) Underflow: products of three lose 2^-126 times extents, but those that matter
    // here are near one: coordinates that decide are below 4 in size, or delta is above 2^-20 of them; 2^-100 is added.
    ECODS_ALWAYS_INLINE static Ints find_near_planes(const std::array<float, 4>& delta, const Corners& x,
                                                     const Spans& x_spans, const Corners& y, const Spans& y_spans,
                                                     std::size_t part, std::uint32_t rows) noexcept {
        Floats q[3][3];
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < 3; ++k) q[c][k] = load(y.at[c][k], part);
        }
        const Floats q1[3] = {q[1][0] - q[0][0], q[1][1] - q[0][1], q[1][2] - q[0][2]};
        const Floats q2[3] = {q[2][0] - q[0][0], q[2][1] - q[0][1], q[2][2] - q[0][2]};
        const Floats mx = q1[1] * q2[2] - q1[2] * q2[1], my = q1[2] * q2[0] - q1[0] * q2[2],
                     mz = q1[0] * q2[1] - q1[1] * q2[0];
        Ints near{};
        for (; rows != 0; rows &= rows - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rows));
            const auto p = [&](std::size_t c, std::size_t k) { return x.at[c][k][i]; };
            const auto extent = [&](std::size_t k) -> Floats {
                const Floats low = x_spans.low[k][i] + Floats{}, high = x_spans.high[k][i] + Floats{};
                return max(high, load(y_spans.high[k], part)) - min(low, load(y_spans.low[k], part));
            };
            const Floats ex = extent(0), ey = extent(1), ez = extent(2);
            const Floats bound = ex * ey * (49 * 0x1p-23f * ez + 12.5f * delta[2]) +
                                 ez * (12.5f * delta[0] * ey + 12.5f * delta[1] * ex) + 0x1p-100f;

            const float u0 = p(1, 0) - p(0, 0), u1 = p(1, 1) - p(0, 1), u2 = p(1, 2) - p(0, 2);
            const float w0 = p(2, 0) - p(0, 0), w1 = p(2, 1) - p(0, 1), w2 = p(2, 2) - p(0, 2);
            const float nx = u1 * w2 - u2 * w1, ny = u2 * w0 - u0 * w2, nz = u0 * w1 - u1 * w0;
            Floats first[3], second[3];
            for (std::size_t c = 0; c < 3; ++c) {
                first[c] = (nx * (q[c][0] - p(0, 0)) + ny * (q[c][1] - p(0, 1))) + nz * (q[c][2] - p(0, 2));
                second[c] = (mx * (p(c, 0) - q[0][0]) + my * (p(c, 1) - q[0][1])) + mz * (p(c, 2) - q[0][2]);
            }
            const Ints apart = (min(first[0], min(first[1], first[2])) > bound) |
                               (max(first[0], max(first[1], first[2])) < -bound) |
                               (min(second[0], min(second[1], second[2])) > bound) |
                               (max(second[0], max(second[1], second[2])) < -bound);
            const Ints is_judged = (ex < extent_max) & (ey < extent_max) & (ez < extent_max);
            near |= ~(apart & is_judged) & (1 << i);
        }
        return near;
    }
    static constexpr float extent_max = 0x1p40f;
};

using Sets = std::array<AxisSet, 2>;

template <class X, class Y>
std::uint64_t widest(const Sets& sets, const X& x, const Y& y) noexcept {
    return dispatch_by_width<Kernel<4>::overlap_mask<X, Y>, Kernel<8>::overlap_mask<X, Y>>(sets, x, y);
}

}  // namespace

std::uint64_t overlap_mask(const Sets& sets, const BvhNode& x, const BvhNode& y) noexcept {
    return widest(sets, x, y);
}
std::uint64_t overlap_mask(const Sets& sets, const BvhNode& x, const TreeLeaf& y) noexcept {
    return widest(sets, x, y);
}
std::uint64_t overlap_mask(const Sets& sets, const TreeLeaf& x, const BvhNode& y) noexcept {
    return widest(sets, x, y);
}
std::uint64_t overlap_mask(const Sets& sets, const TreeLeaf& x, const TreeLeaf& y) noexcept {
    return widest(sets, x, y);
}

}  // namespace ecods
