#include <bit>
#include <cmath>
#include <type_traits>

#include "bvh/axes/distance_axes.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

using DistanceSets = std::array<DistanceSet, 2>;

template <std::size_t width>
struct NearKernel : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::bits_of, Lanes::collect, Lanes::find_ends, Lanes::load, Lanes::part_count, Lanes::place;
    using typename Lanes::Corners, typename Lanes::Floats, typename Lanes::Ints, typename Lanes::SlabAxis,
        typename Lanes::Spans;

    // Where a gap is a NaN, 0.
    ECODS_ALWAYS_INLINE static Floats positive(Floats gap) noexcept { return max(gap, Floats{}); }

    // Sets the squared distances of the lanes of y from those of x along the gap, and returns in lane j those bits i
    // that are not above the limit. Boxes and triangles are projected as they are, where the sets' axes see a box
    // around them.
    //
    // Bound: y as for SlabAxis, and x has the error of a corner and 3.01 v s for products and sums, or of a box 7 v s:
    // below twice point_error, summed as |n_k| (...)_k.
    ECODS_ALWAYS_INLINE static void find_along(const DistanceSet& set, const Direction& n, const TreeLeaf& x,
                                               const TreeLeaf& y, float limit, LaneSquares& squares,
                                               Ints (&near)[part_count]) noexcept {
        const auto& errors = set.axes.point_error;
        const float margin =
            2 * ((std::abs(n[0]) * errors[0] + std::abs(n[1]) * errors[1]) + std::abs(n[2]) * errors[2]);
        const SlabAxis axis(set.axes, Slab{n, 0, margin}, set.axes.b, 1);
        alignas(32) FloatLanes high_x;
        Floats low[part_count], high;
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats unused;
            find_ends(x, n, part, unused, high);
            Lanes::store(high_x, part, high);
            find_ends(y, axis.m, part, low[part], unused);
            low[part] = low[part] - axis.high;
            near[part] = Ints{};
        }
        for (std::size_t i = 0; i < x.count; ++i) {
            for (std::size_t part = 0; part < part_count; ++part) {
                const Floats gap = positive(low[part] - high_x[i]);
                const Floats square = gap * gap * set.square;
                ecods::store(&squares[tree_width * i + part * width], square);
                near[part] |= (square <= limit) & (1 << i);
            }
        }
    }

    // Sets the squared distances of span i of x from the spans of y, for the rows i; where there are some already, only
    // makes them greater. Returns in lane j those bits i that are not above the limit.
    template <bool are_set>
    ECODS_ALWAYS_INLINE static Ints find_near(const Spans& x, const Spans& y, float square, float limit,
                                              std::size_t part, std::uint32_t rows, LaneSquares& squares) noexcept {
        Floats low[3], high[3];
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = load(y.low[k], part);
            high[k] = load(y.high[k], part);
        }
        Ints near{};
        for (; rows != 0; rows &= rows - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rows));
            const auto gap = [&](std::size_t k) { return positive(max(x.low[k][i] - high[k], low[k] - x.high[k][i])); };
            const Floats gx = gap(0), gy = gap(1), gz = gap(2);
            float* const row = &squares[tree_width * i + part * width];
            Floats sum = ((gx * gx + gy * gy) + gz * gz) * square;
            if constexpr (are_set) sum = max(sum, ecods::load<Floats>(row));
            ecods::store(row, sum);
            near |= (sum <= limit) & (1 << i);
        }
        return near;
    }

    // Squared distances of the lanes of `other` from a slab of the other tree; `set` and `shift` as for SlabAxis.
    template <class Other>
    ECODS_ALWAYS_INLINE static void find_slab_squares(const DistanceSet& set, const Slab& slab, const Projection& p,
                                                      const Other& other, float shift,
                                                      Floats (&squares)[part_count]) noexcept {
        const SlabAxis axis(set.axes, slab, p, shift);
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats low, high;
            find_ends(other, axis.m, part, low, high);
            const Floats gap = positive(max(low - axis.high, axis.low - high));
            squares[part] = gap * gap * set.square;
        }
    }

    template <class X, class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t near_mask(const DistanceSets& sets, const Direction& n, float limit,
                                                       const X& x, const Y& y, LaneSquares& squares) noexcept {
        constexpr bool are_leaves = std::is_same_v<X, TreeLeaf> && std::is_same_v<Y, TreeLeaf>;
        Floats over_x[part_count]{}, over_y[part_count]{};
        Ints near[part_count], lanes[part_count];
        std::uint32_t rows = x.lanes();
        const bool has_slab_x = sets[0].axes.a.is_unit, has_slab_y = sets[1].axes.b.is_unit;
        for (Ints& all : near) all = ~Ints{};
        if constexpr (are_leaves) {
            // Of triangles. Boxes have few pairs between which there is more along the gap than their axes see.
            if (has_slab_x) {
                find_along(sets[0], n, x, y, limit, squares, near);
            } else {
                squares.fill(0);
            }
            rows &= bits_of(near);
            if (rows == 0) return 0;
        }
        if (has_slab_x) {
            find_slab_squares(sets[0], x.slab, sets[0].axes.b, y, 1, over_y);
            for (std::size_t part = 0; part < part_count; ++part) lanes[part] = over_y[part] <= limit;
            if (bits_of(lanes) == 0) return 0;
        }
        if (has_slab_y) {
            find_slab_squares(sets[1], y.slab, sets[1].axes.a, x, -1, over_x);
            for (std::size_t part = 0; part < part_count; ++part) {
                lanes[part] = (over_x[part] <= limit) & lane_bits<Ints>(static_cast<int>(part * width));
            }
            rows &= bits_of(lanes);
            if (rows == 0) return 0;
        }

        Corners corners;
        Spans spans_x, spans_y;
        place(sets[0].axes.a, x, corners, spans_x);
        place(sets[0].axes.b, y, corners, spans_y);
        for (std::size_t part = 0; part < part_count; ++part) {
            near[part] &= find_near<are_leaves>(spans_x, spans_y, sets[0].square, limit, part, rows, squares);
        }
        rows = bits_of(near);
        if (rows == 0) return 0;

        place(sets[1].axes.a, x, corners, spans_x);
        place(sets[1].axes.b, y, corners, spans_y);
        std::uint64_t pairs = 0;
        for (std::size_t part = 0; part < part_count; ++part) {
            near[part] &= find_near<true>(spans_x, spans_y, sets[1].square, limit, part, rows, squares);
            near[part] &= (over_y[part] <= limit);
            for (std::uint32_t rest = rows; rest != 0; rest &= rest - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(rest));
                float* const row = &squares[tree_width * i + part * width];
                const float over = over_x[i / width][static_cast<int>(i % width)];
                ecods::store(row, max(max(ecods::load<Floats>(row), over_y[part]), over + Floats{}));
            }
            collect(near[part], part, pairs);
        }
        return pairs & ~std::uint64_t{0} >> (64 - tree_width * y.count);
    }
};

template <class X, class Y>
std::uint64_t widest(const DistanceSets& sets, const Direction& n, float limit, const X& x, const Y& y,
                     LaneSquares& squares) noexcept {
    return dispatch_by_width<NearKernel<4>::near_mask<X, Y>, NearKernel<8>::near_mask<X, Y>>(sets, n, limit, x, y,
                                                                                             squares);
}

}  // namespace

std::uint64_t near_mask(const DistanceSets& sets, const Direction& n, float limit, const BvhNode& x, const BvhNode& y,
                        LaneSquares& squares) noexcept {
    return widest(sets, n, limit, x, y, squares);
}
std::uint64_t near_mask(const DistanceSets& sets, const Direction& n, float limit, const BvhNode& x, const TreeLeaf& y,
                        LaneSquares& squares) noexcept {
    return widest(sets, n, limit, x, y, squares);
}
std::uint64_t near_mask(const DistanceSets& sets, const Direction& n, float limit, const TreeLeaf& x, const BvhNode& y,
                        LaneSquares& squares) noexcept {
    return widest(sets, n, limit, x, y, squares);
}
std::uint64_t near_mask(const DistanceSets& sets, const Direction& n, float limit, const TreeLeaf& x, const TreeLeaf& y,
                        LaneSquares& squares) noexcept {
    return widest(sets, n, limit, x, y, squares);
}

}  // namespace ecods
