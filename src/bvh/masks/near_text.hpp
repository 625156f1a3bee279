// bvh/masks/distance_masks.cpp includes this source once for each instruction set.

// NearMeasure is a measure for PairKernel: it finds lower bounds of squared distances. A pair is excluded if its bound
// exceeds the limit.
struct NearMeasure : ProjectedLanes<float_width> {
    using Value = Floats;
    const std::array<DistanceSet, 2>& sets;
    const Direction& n;
    const float limit;
    LaneBounds& squares;

    ECODS_ALWAYS_INLINE const AxisSet& axes(std::size_t set) const noexcept { return sets[set].axes; }
    template <class Node>
    ECODS_ALWAYS_INLINE void put(std::size_t set, Projection AxisSet::*tree, const Node& node,
                                 Placed& placed) const noexcept {
        place(axes(set).*tree, node, placed);
    }

    ECODS_ALWAYS_INLINE float* row_of(std::size_t i, std::size_t part) const noexcept {
        return &squares[tree_width * i + part * float_width];
    }
    ECODS_ALWAYS_INLINE Value load(std::size_t i, std::size_t part) const noexcept {
        return ECODS_SET::load<Floats>(row_of(i, part));
    }
    ECODS_ALWAYS_INLINE void store(std::size_t i, std::size_t part, Value value) const noexcept {
        ECODS_SET::store(row_of(i, part), value);
    }

    ECODS_ALWAYS_INLINE Ints is_near(Value value) const noexcept { return value <= limit; }
    ECODS_ALWAYS_INLINE Value unknown() const noexcept { return Floats{}; }
    ECODS_ALWAYS_INLINE Value start(const Value (&over_x)[part_count], const Value (&over_y)[part_count], std::size_t i,
                                    std::size_t part) const noexcept {
        return join(over_y[part], over_x[i / float_width][static_cast<int>(i % float_width)] + Floats{});
    }
    ECODS_ALWAYS_INLINE static Value join(Value a, Value b) noexcept { return max(a, b); }

    // Returns the gap, or 0 if the gap is negative or NaN.
    ECODS_ALWAYS_INLINE static Floats positive(Floats gap) noexcept { return max(gap, Floats{}); }

    // Sets `squares` to squared gaps of triangles of x and y along the direction n, and bit i in lane j of `near` if
    // the square for triangle i of x and triangle j of y is at most the limit. Here the triangles themselves are
    // projected, whereas the sets' axes measure boxes around them. For nodes this step is skipped: the gap of two boxes
    // along n is seldom larger than the gaps on their axes.
    //
    // Bound: the projection of y is bounded as for SlabAxis. The projection of x has the error of a corner and 3.01 v s
    // for products and sums, or 7 v s for a box: below twice point_error, summed as |n_k| (...)_k.
    ECODS_ALWAYS_INLINE void look_first(const TreeLeaf& x, const TreeLeaf& y, Ints (&near)[part_count]) const noexcept {
        if (!axes(0).a.is_unit) return squares.fill(0);
        const DistanceSet& set = sets[0];
        const auto& errors = set.axes.point_error;
        const float margin =
            2 * ((std::abs(n[0]) * errors[0] + std::abs(n[1]) * errors[1]) + std::abs(n[2]) * errors[2]);
        const SlabAxis axis(set.axes, Slab{n, 0, margin}, set.axes.b, 1);
        alignas(32) FloatLanes high_x;
        Floats low[part_count], high;
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats unused;
            find_ends(x, n, part, unused, high);
            ProjectedLanes::store(high_x, part, high);
            find_ends(y, axis.m, part, low[part], unused);
            low[part] = low[part] - axis.high;
            near[part] = Ints{};
        }
        for (std::size_t i = 0; i < x.count; ++i) {
            for (std::size_t part = 0; part < part_count; ++part) {
                const Floats gap = positive(low[part] - high_x[i]);
                const Floats square = gap * gap * set.square;
                store(i, part, square);
                near[part] |= is_near(square) & (1 << i);
            }
        }
    }

    ECODS_ALWAYS_INLINE Value of_slab(std::size_t set, const SlabAxis& axis, const Slab&, float, Floats low,
                                      Floats high) const noexcept {
        const Floats gap = positive(max(low - axis.high, axis.low - high));
        return gap * gap * sets[set].square;
    }

    template <std::size_t set>
    ECODS_ALWAYS_INLINE void narrow(Value& value, const Placed& x, const Placed& y, std::size_t i,
                                    std::size_t part) const noexcept {
        const auto gap = [&](std::size_t k) -> Floats {
            const Floats low = ProjectedLanes::load(y.spans.low[k], part),
                         high = ProjectedLanes::load(y.spans.high[k], part);
            return positive(max(x.spans.low[k][i] - high, low - x.spans.high[k][i]));
        };
        const Floats gx = gap(0), gy = gap(1), gz = gap(2);
        const Floats sum = ((gx * gx + gy * gy) + gz * gz) * sets[set].square;
        value = join(sum, value);
    }
};

template <class X, class Y>
[[gnu::noinline]] std::uint64_t near_kernel(const std::array<DistanceSet, 2>& sets, const Direction& n, float limit,
                                            const X& x, const Y& y, LaneBounds& squares) noexcept {
    return PairKernel<NearMeasure>::find({{}, sets, n, limit, squares}, x, y);
}
