// bvh/masks/distance_masks.cpp includes this source once for each instruction set.

struct NearestKernel : ProjectedLanes<float_width> {
    // Returns the pair of lanes with the least weighted sum of squared gaps and squared distances of centers. Gaps have
    // the larger weight; for boxes that overlap, the centers decide.
    template <class X, class Y>
    [[gnu::noinline]] static LanePair find(const DistanceSet& set, const X& x, const Y& y) noexcept {
        Placed placed_x, placed_y;
        place(set.axes.a, x, placed_x);
        place(set.axes.b, y, placed_y);
        const Spans &spans_x = placed_x.spans, &spans_y = placed_y.spans;
        LanePair best{0, 0};
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < x.count; ++i) {
            alignas(32) FloatLanes sums;
            for (std::size_t part = 0; part < part_count; ++part) {
                Floats sum{};
                for (std::size_t k = 0; k < 3; ++k) {
                    const Floats low = load(spans_y.low[k], part), high = load(spans_y.high[k], part);
                    const Floats gap = max(max(spans_x.low[k][i] - high, low - spans_x.high[k][i]), Floats{});
                    const Floats twice = (low + high) - (spans_x.low[k][i] + spans_x.high[k][i]);
                    sum = sum + (16 * (gap * gap) + twice * twice);
                }
                store(sums, part, sum);
            }
            for (std::size_t j = 0; j < y.count; ++j) {
                if (!(sums[j] < least)) continue;
                least = sums[j];
                best = {i, j};
            }
        }
        return best;
    }
};
