// bvh/masks/overlap_mask.cpp includes this source once for each instruction set.

// OverlapMeasure is a measure for PairKernel: it finds masks of the lanes that are not proven disjoint. Slabs separate
// most disjoint pairs whose boxes overlap: nearly flat parts of smooth surfaces, one above the other.
struct OverlapMeasure : ProjectedLanes<float_width> {
    using Value = Ints;
    const std::array<AxisSet, 2>& sets;

    ECODS_ALWAYS_INLINE const AxisSet& axes(std::size_t set) const noexcept { return sets[set]; }
    template <class Node>
    ECODS_ALWAYS_INLINE void put(std::size_t set, Projection AxisSet::*tree, const Node& node,
                                 Placed& placed) const noexcept {
        place(axes(set).*tree, node, placed);
    }

    // A Value is only a mask, which PairKernel keeps itself, so nothing is loaded or stored here.
    ECODS_ALWAYS_INLINE Value load(std::size_t, std::size_t) const noexcept { return unknown(); }
    ECODS_ALWAYS_INLINE void store(std::size_t, std::size_t, const Value&) const noexcept {}
    ECODS_ALWAYS_INLINE Ints is_near(const Value& value) const noexcept { return value; }
    ECODS_ALWAYS_INLINE Value unknown() const noexcept { return ~Ints{}; }
    ECODS_ALWAYS_INLINE Value start(const Value (&)[part_count], const Value (&)[part_count], std::size_t,
                                    std::size_t) const noexcept {
        return unknown();
    }

    ECODS_ALWAYS_INLINE Value of_slab(std::size_t, const SlabAxis& axis, const Slab&, float, Floats low,
                                      Floats high) const noexcept {
        return ~((low > axis.high) | (high < axis.low));
    }

    template <class X, class Y>
    ECODS_ALWAYS_INLINE bool look_beside_slabs(const X& x, const Y& y, Ints (&near)[part_count],
                                               std::uint32_t& rows) const noexcept {
        if constexpr (std::is_same_v<Y, BvhNode>) {
            if (sets[0].a.is_unit && y.is_thin) {
                find_thin(sets[0], x.slab, sets[0].b, y, 1, near);
                if (bits_of(near) == 0) return false;
            }
        }
        if constexpr (std::is_same_v<X, BvhNode>) {
            if (sets[1].b.is_unit && x.is_thin) {
                Ints lanes[part_count];
                for (Ints& all : lanes) all = ~Ints{};
                find_thin(sets[1], y.slab, sets[1].a, x, -1, lanes);
                rows &= lanes_of(lanes);
            }
        }
        return rows != 0;
    }

    // Clears in `lanes` the lanes of the node `other` whose boxes are certainly beyond the slab. The boxes are bounded
    // by the own slab of `other`, which is thinner. `set`, `slab`, `p` and `shift` are as for SlabAxis.
    ECODS_ALWAYS_INLINE static void find_thin(const AxisSet& set, const Slab& slab, const Projection& p,
                                              const BvhNode& other, float shift, Ints (&lanes)[part_count]) noexcept {
        const SlabAxis axis(set, slab, p, shift);
        const ThinAxis thin(axis, other.slab);
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats low, high;
            find_thin_ends(other, thin, part, low, high);
            lanes[part] &= ~((low > axis.high) | (high < axis.low));
        }
    }

    // Clears the lanes of y whose spans are disjoint from the span of lane i of x on an axis. Comparisons with NaN are
    // false, so NaN proves nothing.
    template <std::size_t>
    ECODS_ALWAYS_INLINE void narrow(Value& value, const Placed& x, const Placed& y, std::size_t i,
                                    std::size_t part) const noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            value &= ~((x.spans.low[k][i] > ProjectedLanes::load(y.spans.high[k], part)) |
                       (x.spans.high[k][i] < ProjectedLanes::load(y.spans.low[k], part)));
        }
    }
};

// Finds pairs of lanes that may overlap, and for two leaves also the pairs of triangles that certainly cross.
struct OverlapKernel : PairKernel<OverlapMeasure> {
    using AxisSets = std::array<AxisSet, 2>;

    template <class X, class Y>
    [[gnu::noinline]] static TrianglePairs find(const AxisSets& sets, const X& x, const Y& y) noexcept {
        Ints near[part_count];
        Placed placed[2];
        if (!find_lanes({{}, sets}, x, y, placed, near)) return {};
        const std::uint64_t lanes_of_y = ~std::uint64_t{0} >> (64 - tree_width * y.count);
        std::uint64_t crossing = 0;
        if constexpr (std::is_same_v<X, TreeLeaf> && std::is_same_v<Y, TreeLeaf>) {
            crossing = find_triangles(sets[0], placed[0], placed[1], near);
        }
        return {pairs_of(near, y), crossing & lanes_of_y};
    }

  private:
    // Clears the bits of pairs of triangles that are proven disjoint in `near`, and returns the bits of pairs that are
    // proven to cross.
    ECODS_ALWAYS_INLINE static std::uint64_t find_triangles(const AxisSet& set, const Placed& x, const Placed& y,
                                                            Ints (&near)[part_count]) noexcept {
        if (set.flat_axis >= 0) {
            for (std::size_t part = 0; part < part_count; ++part) {
                near[part] &=
                    FlatLanes::find_near_edges(set, x.corners, x.spans, y.corners, y.spans, part, rows_of(near[part]));
            }
            return 0;
        }
        const TriangleLanes::Normals normals(x.corners);
        std::uint64_t crossing = 0;
        for (std::size_t part = 0; part < part_count; ++part) {
            const auto found = TriangleLanes::find(set.point_error, x.corners, x.spans, normals, y.corners, y.spans,
                                                   part, near[part], rows_of(near[part]));
            near[part] = found.near;
            collect(found.crossing, part, crossing);
        }
        return set.is_bijective ? crossing : 0;
    }
    ECODS_ALWAYS_INLINE static std::uint32_t rows_of(const Ints& near) noexcept {
        return static_cast<std::uint32_t>(any_bits(near));
    }
};
