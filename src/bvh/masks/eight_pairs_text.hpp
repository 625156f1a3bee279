// bvh/masks/overlap_mask.cpp includes this source for AVX-512: EightPairs tests any eight pairs of triangles of two
// leaves at once. Usually few of a leaf's eight triangles are near a given triangle, and testing one against all eight
// would leave most lanes unused. The processor must be able to pick lanes by number and bits by mask (simd/wide.hpp).

struct EightPairs : avx2::ProjectedLanes<8> {
    // Clears the bits of pairs of triangles that are proven disjoint in `pairs`, and returns the bits of pairs that are
    // proven to cross.
    ECODS_ALWAYS_INLINE static std::uint64_t find(const AxisSet& set, const Placed& x, const Placed& y,
                                                  std::uint64_t& pairs) noexcept {
        using Decided = avx2::TriangleLanes;
        std::uint64_t near = 0, crossing = 0;
        for (std::uint64_t rest = pairs; rest != 0;) {
            const wide::PairNumbers eight(rest);
            if (set.flat_axis >= 0) {
                Ints open;
                find_flat(set, x, y, eight, open);
                near |= eight.bits_of(open);
                continue;
            }
            Decided::Vectors p[3], q[3];
            for (std::size_t c = 0; c < 3; ++c) {
                pick(x.corners.at[c], eight.i, p[c]);
                pick(y.corners.at[c], eight.j, q[c]);
            }
            const Decided::Vectors n = Decided::cross(p[1] - p[0], p[2] - p[0]),
                                   m = Decided::cross(q[1] - q[0], q[2] - q[0]);
            Decided::Vectors extent;
            find_extent(x, y, 0, eight, extent.x);
            find_extent(x, y, 1, eight, extent.y);
            find_extent(x, y, 2, eight, extent.z);
            const Ints all = ~Ints{};
            const Decided::Found found = Decided::decide(set.point_error, p, n, q, m, extent, all);
            near |= eight.bits_of(found.near);
            crossing |= eight.bits_of(found.crossing);
        }
        pairs = near;
        return set.is_bijective ? crossing : std::uint64_t{0};
    }

  private:
    ECODS_ALWAYS_INLINE static void pick(const FloatLanes& from, wide::Index8 index, Floats& to) noexcept {
        wide::store(wide::pick(from.data(), index), to);
    }
    ECODS_ALWAYS_INLINE static void pick(const std::array<FloatLanes, 3>& from, wide::Index8 index,
                                         avx2::TriangleLanes::Vectors& to) noexcept {
        pick(from[0], index, to.x);
        pick(from[1], index, to.y);
        pick(from[2], index, to.z);
    }

    // Sets `extent`, for each pair, to the length on an axis of the interval that contains both triangles. max and min
    // have the same operand order as in Vec, for equal bits.
    ECODS_ALWAYS_INLINE static void find_extent(const Placed& x, const Placed& y, std::size_t axis,
                                                const wide::PairNumbers& pairs, Floats& extent) noexcept {
        const wide::Float8 high = wide::larger(wide::pick(x.spans.high[axis].data(), pairs.i),
                                               wide::pick(y.spans.high[axis].data(), pairs.j)),
                           low = wide::smaller(wide::pick(x.spans.low[axis].data(), pairs.i),
                                               wide::pick(y.spans.low[axis].data(), pairs.j));
        wide::store(high - low, extent);
    }

    // Sets `open` to the lanes in which no edge of either triangle is proven to separate the two, as in
    // FlatLanes::find_near_edges.
    ECODS_ALWAYS_INLINE static void find_flat(const AxisSet& set, const Placed& x, const Placed& y,
                                              const wide::PairNumbers& pairs, Ints& open) noexcept {
        const auto k = static_cast<std::size_t>(set.flat_axis + 1) % 3,
                   l = static_cast<std::size_t>(set.flat_axis + 2) % 3;
        avx2::FlatLanes::FlatTriangle<Floats> p, q;
        for (std::size_t c = 0; c < 3; ++c) {
            pick(x.corners.at[c][k], pairs.i, p.x[c]);
            pick(x.corners.at[c][l], pairs.i, p.y[c]);
            pick(y.corners.at[c][k], pairs.j, q.x[c]);
            pick(y.corners.at[c][l], pairs.j, q.y[c]);
        }
        p.find_edges();
        q.find_edges();
        Floats ex, ey;
        find_extent(x, y, k, pairs, ex);
        find_extent(x, y, l, pairs, ey);
        avx2::FlatLanes::find_open(set, k, l, p, q, ex, ey, open);
    }
};
