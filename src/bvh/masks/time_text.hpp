// Text of bvh/masks/time_masks.cpp, compiled for each instruction set.

// The interval of times in which lanes may share points; a pair is in question while its interval is not empty. The
// measures differ in how sets of axes narrow it.
struct TimeMeasure : ProjectedLanes<float_width> {
    // An interval of times, with begin at least 0; empty if begin > end.
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
