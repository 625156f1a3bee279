// bvh/masks/overlap_mask.cpp includes this source for registers of sixteen floats.

// WideOverlap tests pairs of lanes as OverlapKernel does, but two lanes of the second node at once: a mask of sixteen
// bits is two bytes of the result.
struct WideOverlap : avx2::ProjectedLanes<8> {
    using AxisSets = std::array<AxisSet, 2>;

    // Returns the bits of `pairs` for lanes whose spans overlap on all axes.
    ECODS_ALWAYS_INLINE static std::uint64_t find_near(const Spans& x, const Spans& y, std::uint64_t pairs) noexcept {
        const wide::Floats x_low[3] = {twice(x.low[0]), twice(x.low[1]), twice(x.low[2])},
                           x_high[3] = {twice(x.high[0]), twice(x.high[1]), twice(x.high[2])},
                           y_low[3] = {twice(y.low[0]), twice(y.low[1]), twice(y.low[2])},
                           y_high[3] = {twice(y.high[0]), twice(y.high[1]), twice(y.high[2])};
        return near_two<0>(x_low, x_high, y_low, y_high, pairs) | near_two<2>(x_low, x_high, y_low, y_high, pairs) |
               near_two<4>(x_low, x_high, y_low, y_high, pairs) | near_two<6>(x_low, x_high, y_low, y_high, pairs);
    }

    // Returns a mask of the lanes of `other` that are not certainly beyond a slab. The arguments are as for SlabAxis.
    template <class Other>
    ECODS_ALWAYS_INLINE static std::uint32_t in_slab(const AxisSet& set, const Slab& slab, const Projection& p,
                                                     const Other& other, float shift) noexcept {
        const SlabAxis axis(set, slab, p, shift);
        Floats low, high;
        find_ends(other, axis.m, 0, low, high);
        return not_outside(low, high, axis.low, axis.high);
    }

    // Returns a mask of the lanes of `other` that OverlapMeasure::find_thin does not clear.
    ECODS_ALWAYS_INLINE static std::uint32_t in_thin(const AxisSet& set, const Slab& slab, const Projection& p,
                                                     const BvhNode& other, float shift) noexcept {
        const SlabAxis axis(set, slab, p, shift);
        Floats low, high;
        find_thin_ends(other, ThinAxis(axis, other.slab), 0, low, high);
        return not_outside(low, high, axis.low, axis.high);
    }

    // Returns the result of OverlapKernel::find for these arguments.
    template <class X, class Y>
    [[gnu::noinline]] static TrianglePairs find(const AxisSets& sets, const X& x, const Y& y) noexcept {
        std::uint64_t pairs = ~std::uint64_t{0} >> (64 - tree_width * y.count);
        if (sets[0].a.is_unit) {
            pairs &= bytes_of(in_slab(sets[0], x.slab, sets[0].b, y, 1));
            if (pairs == 0) return {};
        }
        std::uint32_t lanes_of_x = x.lanes();
        if (sets[1].b.is_unit) {
            lanes_of_x &= in_slab(sets[1], y.slab, sets[1].a, x, -1);
            if (lanes_of_x == 0) return {};
        }
        pairs &= in_each_byte(lanes_of_x);
        if constexpr (std::is_same_v<Y, BvhNode>) {
            if (sets[0].a.is_unit && y.is_thin) {
                pairs &= bytes_of(in_thin(sets[0], x.slab, sets[0].b, y, 1));
                if (pairs == 0) return {};
            }
        }
        if constexpr (std::is_same_v<X, BvhNode>) {
            if (sets[1].b.is_unit && x.is_thin) {
                pairs &= in_each_byte(in_thin(sets[1], y.slab, sets[1].a, x, -1));
                if (pairs == 0) return {};
            }
        }

        Placed first_x, first_y, second_x, second_y;
        place(sets[0].a, x, first_x);
        place(sets[0].b, y, first_y);
        pairs = find_near(first_x.spans, first_y.spans, pairs);
        if (pairs == 0) return {};
        place(sets[1].a, x, second_x);
        place(sets[1].b, y, second_y);
        pairs = find_near(second_x.spans, second_y.spans, pairs);
        if (pairs == 0) return {};

        std::uint64_t crossing = 0;
        if constexpr (std::is_same_v<X, TreeLeaf> && std::is_same_v<Y, TreeLeaf>) {
            crossing = EightPairs::find(sets[0], first_x, first_y, pairs);
        }
        return {pairs, crossing};
    }

  private:
    ECODS_ALWAYS_INLINE static wide::Floats twice(const FloatLanes& lanes) noexcept {
        return wide::twice(lanes.data());
    }

    // Returns the bits of `pairs` for lanes j and j + 1 of y that belong to pairs whose spans overlap on all axes.
    template <int j>
    ECODS_ALWAYS_INLINE static std::uint64_t near_two(const wide::Floats (&x_low)[3], const wide::Floats (&x_high)[3],
                                                      const wide::Floats (&y_low)[3], const wide::Floats (&y_high)[3],
                                                      std::uint64_t pairs) noexcept {
        // Each comparison waits for the mask of the comparison before it. Two chains of comparisons take half as long
        // as one; more chains are no faster.
        auto begin = static_cast<Mask>(pairs >> (8 * j));
        Mask end = all_lanes;
        for (std::size_t k = 0; k < 3; ++k) {
            begin = not_above(begin, x_low[k], two_of<j>(y_high[k]));
            end = not_below(end, x_high[k], two_of<j>(y_low[k]));
        }
        return static_cast<std::uint64_t>(begin & end) << (8 * j);
    }
};
