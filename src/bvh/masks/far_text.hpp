// bvh/masks/distance_masks.cpp includes this source once for each instruction set.

struct FarKernel : ProjectedLanes<float_width> {
    template <class X, class Y>
    [[gnu::noinline]] static std::uint64_t find(const FarGap& gap, float limit, const X& x, const Y& y,
                                                LaneBounds& ranks) noexcept {
        alignas(32) FloatLanes high_x;
        Floats low[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats unused, high;
            find_ends(x, gap.a, part, unused, high);
            store(high_x, part, high);
            find_ends(y, gap.b, part, low[part], unused);
        }
        std::uint64_t pairs = 0;
        for (std::size_t part = 0; part < part_count; ++part) {
            Ints near{};
            for (std::size_t i = 0; i < x.count; ++i) {
                const Floats rank = max((low[part] - high_x[i]) + gap.reach, Floats{});
                ECODS_SET::store(&ranks[tree_width * i + part * float_width], rank);
                near |= (rank <= limit) & (1 << i);
            }
            collect(near, part, pairs);
        }
        return pairs & ~std::uint64_t{0} >> (64 - tree_width * y.count);
    }
};
