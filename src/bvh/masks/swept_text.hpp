// bvh/masks/time_masks.cpp includes this source once for each instruction set.

// Holds two reciprocals of a closing speed. The reciprocals are rounded such that gap * to_begin is a lower bound of
// the time at which two intervals meet, and distance * to_end an upper bound of the time at which they part, for the
// distance until they have passed each other.
struct Pace {
    float to_begin, to_end;

    ECODS_ALWAYS_INLINE explicit Pace(float speed) noexcept
        : to_begin(std::min((1 - 0x1p-20f) / speed, 0x1p100f)), to_end((1 + 0x1p-20f) / speed) {}
};
inline constexpr float lost_time = 0x1p-100f;

// SweptMeasure is a measure for PairKernel: it bounds the times at which lanes of a translated body and of another body
// may share points.
struct SweptMeasure : TimeMeasure {
    const std::array<SweptSet, 2>& sets;

    ECODS_ALWAYS_INLINE const AxisSet& axes(std::size_t set) const noexcept { return sets[set].axes; }
    template <class Node>
    ECODS_ALWAYS_INLINE void put(std::size_t set, Projection AxisSet::*tree, const Node& node,
                                 Placed& placed) const noexcept {
        place(axes(set).*tree, node, placed);
        turn(sets[set], placed.spans);
    }

    // Narrows `value` to the times at which two intervals overlap. Their gap is `gap` at time 0, and they have passed
    // each other after the distance `rest`. A time that is NaN changes nothing.
    ECODS_ALWAYS_INLINE static void meet(Value& value, const Pace& pace, Floats gap, Floats rest) noexcept {
        value.begin = max(gap * pace.to_begin, value.begin);
        value.end = min(rest * pace.to_end + lost_time, value.end);
    }

    // Mirrors the spans on each axis on which the first tree moves downwards, so that it moves upwards on all axes.
    ECODS_ALWAYS_INLINE static void turn(const SweptSet& set, Spans& spans) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            if (!(set.velocity[k] < 0)) continue;
            for (std::size_t part = 0; part < part_count; ++part) {
                const Floats low = ProjectedLanes::load(spans.low[k], part),
                             high = ProjectedLanes::load(spans.high[k], part);
                ProjectedLanes::store(spans.low[k], part, -high);
                ProjectedLanes::store(spans.high[k], part, -low);
            }
        }
    }

    ECODS_ALWAYS_INLINE Value start(const Value (&over_x)[part_count], const Value (&over_y)[part_count], std::size_t i,
                                    std::size_t part) const noexcept {
        const Value &x = over_x[i / float_width], &y = over_y[part];
        const auto lane = static_cast<int>(i % float_width);
        return {max(y.begin, x.begin[lane] + Floats{}), min(y.end, x.end[lane] + Floats{})};
    }

    template <std::size_t set>
    ECODS_ALWAYS_INLINE void narrow(Value& value, const Placed& x, const Placed& y, std::size_t i,
                                    std::size_t part) const noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            const Pace pace(std::abs(sets[set].velocity[k]));
            meet(value, pace, ProjectedLanes::load(y.spans.low[k], part) - x.spans.high[k][i],
                 ProjectedLanes::load(y.spans.high[k], part) - x.spans.low[k][i]);
        }
    }

    ECODS_ALWAYS_INLINE Value of_slab(std::size_t set, const SlabAxis& axis, const Slab& slab, float shift, Floats low,
                                      Floats high) const noexcept {
        const auto& n = slab.normal;
        const auto& v = sets[set].velocity;
        // `speed` is the speed of the slab relative to the other tree, along the slab's normal.
        const float speed = shift * ((n[0] * v[0] + n[1] * v[1]) + n[2] * v[2]);
        const Pace pace(std::abs(speed));
        Value value = unknown();
        if (speed < 0) {
            meet(value, pace, axis.low - high, axis.high - low);
        } else {
            meet(value, pace, low - axis.high, high - axis.low);
        }
        return value;
    }
};

template <class X, class Y>
[[gnu::noinline]] std::uint64_t swept_kernel(const std::array<SweptSet, 2>& sets, float limit, const X& x, const Y& y,
                                             LaneBounds& times) noexcept {
    alignas(32) LaneBounds ends;
    return PairKernel<SweptMeasure>::find({{{}, limit, times, ends}, sets}, x, y);
}
