#include <bit>
#include <cmath>

#include "bvh/axes/swept_axes.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

using SweptSets = std::array<SweptSet, 2>;

// From the gap between two intervals that approach each other, and from how far they are from having passed, to times.
struct Pace {
    float to_begin, to_end;

    ECODS_ALWAYS_INLINE explicit Pace(float speed) noexcept
        : to_begin(std::min((1 - 0x1p-20f) / speed, 0x1p100f)), to_end((1 + 0x1p-20f) / speed) {}
};
constexpr float lost_time = 0x1p-100f;

template <std::size_t width>
struct SweptKernel : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::bits_of, Lanes::collect, Lanes::find_ends, Lanes::load, Lanes::part_count, Lanes::place;
    using typename Lanes::Corners, typename Lanes::Floats, typename Lanes::Ints, typename Lanes::SlabAxis,
        typename Lanes::Spans;

    // When lanes begin to share points, at least 0, and when they end to.
    struct Interval {
        Floats begin, end;
    };

    // Where a time is a NaN, it limits nothing.
    ECODS_ALWAYS_INLINE static void meet(Interval& interval, const Pace& pace, Floats gap, Floats rest) noexcept {
        interval.begin = max(gap * pace.to_begin, interval.begin);
        interval.end = min(rest * pace.to_end + lost_time, interval.end);
    }

    // Turns axes so that the first tree moves upwards on them.
    ECODS_ALWAYS_INLINE static void turn(const SweptSet& set, Spans& spans) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            if (!(set.velocity[k] < 0)) continue;
            for (std::size_t part = 0; part < part_count; ++part) {
                const Floats low = load(spans.low[k], part), high = load(spans.high[k], part);
                Lanes::store(spans.low[k], part, -high);
                Lanes::store(spans.high[k], part, -low);
            }
        }
    }

    // The intervals of span i of x with the spans of y, for the rows i; where there are some already, what they have in
    // common with these. Returns in lane j those bits i that have one.
    template <bool are_set>
    ECODS_ALWAYS_INLINE static Ints find_near(const SweptSet& set, const Spans& x, const Spans& y, float limit,
                                              std::size_t part, std::uint32_t rows, LaneTimes& times,
                                              LaneTimes& ends) noexcept {
        const Pace pace[3] = {Pace(std::abs(set.velocity[0])), Pace(std::abs(set.velocity[1])),
                              Pace(std::abs(set.velocity[2]))};
        Floats low[3], high[3];
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = load(y.low[k], part);
            high[k] = load(y.high[k], part);
        }
        Ints near{};
        for (; rows != 0; rows &= rows - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rows));
            const std::size_t at = tree_width * i + part * width;
            Interval interval{Floats{}, Floats{} + limit};
            if constexpr (are_set) interval = {ecods::load<Floats>(&times[at]), ecods::load<Floats>(&ends[at])};
            for (std::size_t k = 0; k < 3; ++k) meet(interval, pace[k], low[k] - x.high[k][i], high[k] - x.low[k][i]);
            ecods::store(&times[at], interval.begin);
            ecods::store(&ends[at], interval.end);
            near |= (interval.begin <= interval.end) & (1 << i);
        }
        return near;
    }

    // The intervals of the lanes of `other` with a slab of the other tree; `set` and `shift` as for SlabAxis.
    template <class Other>
    ECODS_ALWAYS_INLINE static void find_slab(const SweptSet& set, const Slab& slab, const Projection& p,
                                              const Other& other, float shift, float limit,
                                              Interval (&intervals)[part_count]) noexcept {
        const SlabAxis axis(set.axes, slab, p, shift);
        const auto& n = slab.normal;
        const auto& v = set.velocity;
        // Of the slab, seen from the other.
        const float speed = shift * ((n[0] * v[0] + n[1] * v[1]) + n[2] * v[2]);
        const Pace pace(std::abs(speed));
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats low, high;
            find_ends(other, axis.m, part, low, high);
            intervals[part] = {Floats{}, Floats{} + limit};
            if (speed < 0) {
                meet(intervals[part], pace, axis.low - high, axis.high - low);
            } else {
                meet(intervals[part], pace, low - axis.high, high - axis.low);
            }
        }
    }

    ECODS_ALWAYS_INLINE static Ints are_near(const Interval& interval) noexcept {
        return interval.begin <= interval.end;
    }

    template <class X, class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t swept_mask(const SweptSets& sets, float limit, const X& x, const Y& y,
                                                        LaneTimes& times) noexcept {
        Interval over_x[part_count], over_y[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            over_x[part] = over_y[part] = {Floats{}, Floats{} + limit};
        }
        Ints near[part_count], lanes[part_count];
        std::uint32_t rows = x.lanes();
        for (Ints& all : near) all = ~Ints{};
        if (sets[0].axes.a.is_unit) {
            find_slab(sets[0], x.slab, sets[0].axes.b, y, 1, limit, over_y);
            for (std::size_t part = 0; part < part_count; ++part) lanes[part] = are_near(over_y[part]);
            if (bits_of(lanes) == 0) return 0;
        }
        if (sets[1].axes.b.is_unit) {
            find_slab(sets[1], y.slab, sets[1].axes.a, x, -1, limit, over_x);
            for (std::size_t part = 0; part < part_count; ++part) {
                lanes[part] = are_near(over_x[part]) & lane_bits<Ints>(static_cast<int>(part * width));
            }
            rows &= bits_of(lanes);
            if (rows == 0) return 0;
        }

        alignas(32) LaneTimes ends;
        Corners corners;
        Spans spans_x, spans_y;
        place(sets[0].axes.a, x, corners, spans_x);
        place(sets[0].axes.b, y, corners, spans_y);
        turn(sets[0], spans_x);
        turn(sets[0], spans_y);
        for (std::size_t part = 0; part < part_count; ++part) {
            near[part] &= find_near<false>(sets[0], spans_x, spans_y, limit, part, rows, times, ends);
        }
        rows = bits_of(near);
        if (rows == 0) return 0;

        place(sets[1].axes.a, x, corners, spans_x);
        place(sets[1].axes.b, y, corners, spans_y);
        turn(sets[1], spans_x);
        turn(sets[1], spans_y);
        std::uint64_t pairs = 0;
        for (std::size_t part = 0; part < part_count; ++part) {
            near[part] &= find_near<true>(sets[1], spans_x, spans_y, limit, part, rows, times, ends);
            Ints all{};
            for (std::uint32_t rest = rows; rest != 0; rest &= rest - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(rest));
                const std::size_t at = tree_width * i + part * width;
                const float begin = over_x[i / width].begin[static_cast<int>(i % width)];
                const float end = over_x[i / width].end[static_cast<int>(i % width)];
                const Floats from = max(max(ecods::load<Floats>(&times[at]), over_y[part].begin), begin + Floats{});
                const Floats to = min(min(ecods::load<Floats>(&ends[at]), over_y[part].end), end + Floats{});
                ecods::store(&times[at], from);
                all |= (from <= to) & (1 << i);
            }
            near[part] &= all;
            collect(near[part], part, pairs);
        }
        return pairs & ~std::uint64_t{0} >> (64 - tree_width * y.count);
    }
};

template <class X, class Y>
std::uint64_t widest(const SweptSets& sets, float limit, const X& x, const Y& y, LaneTimes& times) noexcept {
    return dispatch_by_width<SweptKernel<4>::swept_mask<X, Y>, SweptKernel<8>::swept_mask<X, Y>>(sets, limit, x, y,
                                                                                                 times);
}

}  // namespace

std::uint64_t swept_mask(const SweptSets& sets, float limit, const BvhNode& x, const BvhNode& y,
                         LaneTimes& times) noexcept {
    return widest(sets, limit, x, y, times);
}
std::uint64_t swept_mask(const SweptSets& sets, float limit, const BvhNode& x, const TreeLeaf& y,
                         LaneTimes& times) noexcept {
    return widest(sets, limit, x, y, times);
}
std::uint64_t swept_mask(const SweptSets& sets, float limit, const TreeLeaf& x, const BvhNode& y,
                         LaneTimes& times) noexcept {
    return widest(sets, limit, x, y, times);
}
std::uint64_t swept_mask(const SweptSets& sets, float limit, const TreeLeaf& x, const TreeLeaf& y,
                         LaneTimes& times) noexcept {
    return widest(sets, limit, x, y, times);
}

}  // namespace ecods
