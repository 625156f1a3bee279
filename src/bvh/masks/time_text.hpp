// bvh/masks/time_masks.cpp includes this source once for each instruction set.

// TimeMeasure is the base of measures whose values are intervals of time in which lanes may share points. A pair is
// excluded if its interval is empty. Derived measures differ in how a set of axes narrows the interval.
struct TimeMeasure : ProjectedLanes<float_width> {
    // Holds an interval of times in each lane; begin is at least 0. The interval is empty if begin > end.
    struct Value {
        Floats begin, end;
    };
    const float limit;
    LaneBounds &begins, &ends;

    ECODS_ALWAYS_INLINE Value load(std::size_t i, std::size_t part) const noexcept {
        const std::size_t at = tree_width * i + part * float_width;
        return {ECODS_SET::load<Floats>(&begins[at]), ECODS_SET::load<Floats>(&ends[at])};
    }
    ECODS_ALWAYS_INLINE void store(std::size_t i, std::size_t part, const Value& value) const noexcept {
        const std::size_t at = tree_width * i + part * float_width;
        ECODS_SET::store(&begins[at], value.begin);
        ECODS_SET::store(&ends[at], value.end);
    }

    ECODS_ALWAYS_INLINE Ints is_near(const Value& value) const noexcept { return value.begin <= value.end; }
    ECODS_ALWAYS_INLINE Value unknown() const noexcept { return {Floats{}, Floats{} + limit}; }
};
