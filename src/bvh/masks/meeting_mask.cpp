// Chords of gaps, for eight lanes against eight.
//
// Rounding. Ends of boxes and triangles have the margins of separating_axes.hpp, which hold for the ends as computed; a
// gap is a difference of two, which rounds by v = 2^-23 of itself at most, so that its sign is right. A chord's zero is
// f = g0 / (g0 - g1), of gaps of opposite signs: each is off by v of itself, their difference by 2 v and the quotient
// by one more: below 5 v, for which 8 v of f are taken off or added. A difference of gaps of opposite signs is no less
// than either, so where underflow makes a gap zero, it proves nothing, and where it does not, the quotient is defined.
// A quotient that underflows is off by 2^-126: 2^-100 is taken off or added, too. What is left of it begins at 0 or
// later. NaN compares false, and proves nothing.
#include <bit>
#include <cmath>

#include "bvh/axes/motion_axes.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

using MotionSets = std::array<MotionSet, 2>;

template <std::size_t width>
struct MeetingKernel : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::bits_of, Lanes::collect, Lanes::load, Lanes::part_count, Lanes::place;
    using typename Lanes::Corners, typename Lanes::Floats, typename Lanes::Ints, typename Lanes::Spans;

    // The times that are left to a pair: none where first > last.
    struct Times {
        Floats first, last;
    };

    ECODS_ALWAYS_INLINE static void shorten(Times& times, Floats gap_start, Floats gap_end) noexcept {
        const Floats zero{}, one = zero + 1.0f, two = zero + 2.0f;
        const Ints before = gap_start > zero, after = gap_end > zero;
        const Floats at = gap_start / (gap_start - gap_end);
        const Floats first = select(before, select(after, two, at * (1 - 8 * 0x1p-23f) - 0x1p-100f), zero);
        const Floats last = select(~before & after, at * (1 + 8 * 0x1p-23f) + 0x1p-100f, one);
        times.first = max(first, times.first);
        times.last = min(last, times.last);
    }

    // Both nodes on three axes, at the start and at the end.
    struct Moving {
        Spans start, end;

        template <class Node>
        ECODS_ALWAYS_INLINE Moving(const Projection& p, const Projection& q, const Node& node) noexcept {
            Corners corners;
            place(p, node, corners, start);
            place(q, node, corners, end);
        }
    };

    ECODS_ALWAYS_INLINE static Times shorten_on(const Moving& x, const Moving& y, std::size_t i, std::size_t part,
                                                Times times) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            shorten(times, load(y.start.low[k], part) - x.start.high[k][i],
                    load(y.end.low[k], part) - x.end.high[k][i]);
            shorten(times, x.start.low[k][i] - load(y.start.high[k], part),
                    x.end.low[k][i] - load(y.end.high[k], part));
        }
        return times;
    }

    template <class X, class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t meeting_mask(const MotionSets& sets, float limit, const X& x, const Y& y,
                                                          LaneTimes& times) noexcept {
        const Moving x0(sets[0].start.a, sets[0].end.a, x), y0(sets[0].start.b, sets[0].end.b, y);
        const Moving x1(sets[1].start.a, sets[1].end.a, x), y1(sets[1].start.b, sets[1].end.b, y);
        std::uint64_t pairs = 0;
        for (std::size_t part = 0; part < part_count; ++part) {
            Ints near{};
            for (std::uint32_t rows = x.lanes(); rows != 0; rows &= rows - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(rows));
                Times left{Floats{}, Floats{} + limit};
                left = shorten_on(x0, y0, i, part, left);
                left = shorten_on(x1, y1, i, part, left);
                near |= ~(left.first > left.last) & (1 << i);
                ecods::store(&times[tree_width * i + part * width], left.first);
            }
            collect(near, part, pairs);
        }
        return pairs & ~std::uint64_t{0} >> (64 - tree_width * y.count);
    }
};

template <class X, class Y>
std::uint64_t widest(const MotionSets& sets, float limit, const X& x, const Y& y, LaneTimes& times) noexcept {
    return dispatch_by_width<MeetingKernel<4>::meeting_mask<X, Y>, MeetingKernel<8>::meeting_mask<X, Y>>(sets, limit, x,
                                                                                                         y, times);
}

}  // namespace

std::uint64_t meeting_mask(const MotionSets& sets, float limit, const BvhNode& x, const BvhNode& y,
                           LaneTimes& times) noexcept {
    return widest(sets, limit, x, y, times);
}
std::uint64_t meeting_mask(const MotionSets& sets, float limit, const BvhNode& x, const TreeLeaf& y,
                           LaneTimes& times) noexcept {
    return widest(sets, limit, x, y, times);
}
std::uint64_t meeting_mask(const MotionSets& sets, float limit, const TreeLeaf& x, const BvhNode& y,
                           LaneTimes& times) noexcept {
    return widest(sets, limit, x, y, times);
}
std::uint64_t meeting_mask(const MotionSets& sets, float limit, const TreeLeaf& x, const TreeLeaf& y,
                           LaneTimes& times) noexcept {
    return widest(sets, limit, x, y, times);
}

}  // namespace ecods
