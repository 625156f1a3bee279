// bvh/masks/time_masks.cpp includes this source once for each instruction set.

// MeetingMeasure is a measure for PairKernel: it finds the intervals of time in which lanes of two moving nodes may
// meet, from the chords of their gaps.
//
// Rounding. Ends of boxes and triangles have the margins of separating_axes.hpp, which hold for the ends as computed. A
// gap is a difference of two ends, which rounds by at most v = 2^-23 of itself, so its sign is right. A chord's zero is
// f = g0 / (g0 - g1), for gaps of opposite signs. Each gap is off by v of itself, their difference by 2 v and the
// quotient by one more: below 5 v, for which 8 v of f is subtracted or added. The difference of two gaps of opposite
// signs has at least the magnitude of each. So if underflow makes a gap zero, it proves nothing; otherwise the quotient
// is defined. A quotient that underflows is off by 2^-126: 2^-100 is subtracted or added, too. The intervals that
// remain begin at 0 or later. Comparisons with NaN are false, so NaN proves nothing.
// Claim: verify/proofs/float_determinants.py
// Claim: verify/proofs/motion_chords.md
struct MeetingMeasure : TimeMeasure {
    const std::array<MotionSet, 2>& sets;

    ECODS_ALWAYS_INLINE static void shorten(Value& value, Floats gap_start, Floats gap_end) noexcept {
        const Floats zero{}, one = zero + 1.0f, two = zero + 2.0f;
        const Ints before = gap_start > zero, after = gap_end > zero;
        const Floats at = gap_start / (gap_start - gap_end);
        const Floats first = select(before, select(after, two, at * (1 - 8 * 0x1p-23f) - 0x1p-100f), zero);
        const Floats last = select(~before & after, at * (1 + 8 * 0x1p-23f) + 0x1p-100f, one);
        value.begin = max(first, value.begin);
        value.end = min(last, value.end);
    }

    // Holds a node on three axes, at the start and at the end of the motion.
    struct Placed {
        ProjectedLanes::Placed start, end;
    };
    template <class Node>
    ECODS_ALWAYS_INLINE void put(std::size_t set, Projection AxisSet::*tree, const NodeAtEnds<Node>& node,
                                 Placed& placed) const noexcept {
        place(sets[set].start.*tree, node.start, placed.start);
        place(sets[set].end.*tree, node.end, placed.end);
    }

    ECODS_ALWAYS_INLINE Value start(const Value (&)[part_count], const Value (&)[part_count], std::size_t,
                                    std::size_t) const noexcept {
        return unknown();
    }

    template <std::size_t>
    ECODS_ALWAYS_INLINE void narrow(Value& value, const Placed& x, const Placed& y, std::size_t i,
                                    std::size_t part) const noexcept {
        const auto part_of = [&](const FloatLanes& lanes) -> Floats { return ProjectedLanes::load(lanes, part); };
        const Spans &x0 = x.start.spans, &x1 = x.end.spans, &y0 = y.start.spans, &y1 = y.end.spans;
        for (std::size_t k = 0; k < 3; ++k) {
            shorten(value, part_of(y0.low[k]) - x0.high[k][i], part_of(y1.low[k]) - x1.high[k][i]);
            shorten(value, x0.low[k][i] - part_of(y0.high[k]), x1.low[k][i] - part_of(y1.high[k]));
        }
    }
};

template <class X, class Y>
[[gnu::noinline]] std::uint64_t meeting_kernel(const std::array<MotionSet, 2>& sets, float limit, const X& x,
                                               const Y& y, LaneBounds& times) noexcept {
    alignas(32) LaneBounds ends;
    return PairKernel<MeetingMeasure>::find({{{}, limit, times, ends}, sets}, x, y);
}
