// Text of bvh/masks/time_masks.cpp, compiled for each instruction set.

// Times from which on, and until which, lanes may share points: in question while there are any. The measures differ in
// what sets of axes say of them.
struct TimeMeasure : ProjectedLanes<float_width> {
    // None where begin > end; begin is at least 0.
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
