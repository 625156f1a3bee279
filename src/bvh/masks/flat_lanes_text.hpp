// bvh/masks/overlap_mask.cpp includes this source once for each instruction set.

struct FlatLanes : ProjectedLanes<float_width> {
    static constexpr float extent_max = 0x1p40f;

    // Holds a triangle projected along the axis on which both trees are flat. Number is float for one triangle of x in
    // all lanes, and Floats for a triangle of y in each lane.
    template <class Number>
    struct FlatTriangle {
        Number x[3], y[3];         // corners
        Number ex[3], ey[3];       // edge i begins at corner i
        Number least[3], most[3];  // range on the triangle of each edge's line function, which is 0 on the edge

        ECODS_ALWAYS_INLINE void find_edges() noexcept {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t to = (i + 1) % 3, third = (i + 2) % 3;
                ex[i] = x[to] - x[i];
                ey[i] = y[to] - y[i];
                const Number turn = ex[i] * (y[third] - y[i]) - ey[i] * (x[third] - x[i]);
                least[i] = below_zero(turn);
                most[i] = turn - least[i];  // exact: least is 0 or turn
            }
        }
    };

    ECODS_ALWAYS_INLINE static float below_zero(float x) noexcept { return std::min(x, 0.0f); }
    ECODS_ALWAYS_INLINE static Floats below_zero(Floats x) noexcept { return min(x, Floats{}); }

    // Returns the lanes in which a line parallel to an edge of `own` certainly separates the triangles.
    //
    // Let n be a vector perpendicular to the edge. The computed n is used, since any vector is sound. The edge's line
    // function has the value n . (z - p) at a point z, where p is the corner at which the edge begins, as computed.
    //
    // Bound, with v = 2^-23, d the error of a corner and E the extents of both triangles together, which no difference
    // of two corners exceeds. A value of the line function is off by sum |n_k| (d_k + 3.01 v E_k) for the corner, the
    // difference, products and their sum. The values at the edge's ends, which are taken for 0, are off by no more. Two
    // such errors, and rounding the sum on the right, which costs v E_k, are sum |n_k| (2 d_k + 7.02 v E_k). `error` is
    // 2.01 d + 7.1 v E, which also covers its own evaluation. Underflow: products lose 2^-126 each, far below the
    // 2^-100 that is added.
    // Claim: verify/proofs/float_determinants.py
    template <class Own, class Other>
    ECODS_ALWAYS_INLINE static Ints find_parted(const FlatTriangle<Own>& own, const FlatTriangle<Other>& other,
                                                const Floats (&error)[2]) noexcept {
        Ints apart{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Own ex = own.ex[i], ey = own.ey[i];
            const Floats bound = (size_of(ey) * error[0] + size_of(ex) * error[1]) + 0x1p-100f;
            Floats side[3];
            for (std::size_t c = 0; c < 3; ++c) side[c] = ex * (other.y[c] - own.y[i]) - ey * (other.x[c] - own.x[i]);
            apart |= (min(side[0], min(side[1], side[2])) > own.most[i] + bound) |
                     (max(side[0], max(side[1], side[2])) < own.least[i] - bound);
        }
        return apart;
    }
    ECODS_ALWAYS_INLINE static float size_of(float x) noexcept { return std::abs(x); }
    ECODS_ALWAYS_INLINE static Floats size_of(Floats x) noexcept { return absolute(x); }

    // Returns integers whose bit i in lane j, for i in `rows`, is set if no edge of triangle i of x or triangle j of y
    // is proven to separate the two in the projection along the flat axis. Triangles that are separated in the
    // projection are disjoint in the world, too.
    ECODS_ALWAYS_INLINE static Ints find_near_edges(const AxisSet& set, const Corners& x, const Spans& x_spans,
                                                    const Corners& y, const Spans& y_spans, std::size_t part,
                                                    std::uint32_t rows) noexcept {
        const auto k = static_cast<std::size_t>(set.flat_axis + 1) % 3,
                   l = static_cast<std::size_t>(set.flat_axis + 2) % 3;
        FlatTriangle<Floats> q;
        for (std::size_t c = 0; c < 3; ++c) {
            q.x[c] = load(y.at[c][k], part);
            q.y[c] = load(y.at[c][l], part);
        }
        q.find_edges();
        Ints near{};
        for (; rows != 0; rows &= rows - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rows));
            const auto extent = [&](std::size_t axis) -> Floats {
                const auto low = broadcast<Floats>(x_spans.low[axis][i]),
                           high = broadcast<Floats>(x_spans.high[axis][i]);
                return max(high, load(y_spans.high[axis], part)) - min(low, load(y_spans.low[axis], part));
            };
            FlatTriangle<float> p;
            for (std::size_t c = 0; c < 3; ++c) {
                p.x[c] = x.at[c][k][i];
                p.y[c] = x.at[c][l][i];
            }
            p.find_edges();
            Ints open;
            find_open(set, k, l, p, q, extent(k), extent(l), open);
            near |= open & (1 << i);
        }
        return near;
    }

    // Sets `open` to the lanes in which no edge of p or q is proven to separate the two. `ex` and `ey` are the extents
    // of both triangles together on the axes k and l. Extents of 2^40 or more could overflow, and prove nothing, as in
    // TriangleLanes::decide.
    template <class NumberOfP>
    ECODS_ALWAYS_INLINE static void find_open(const AxisSet& set, std::size_t k, std::size_t l,
                                              const FlatTriangle<NumberOfP>& p, const FlatTriangle<Floats>& q,
                                              const Floats& ex, const Floats& ey, Ints& open) noexcept {
        const Floats error[2] = {2.01f * set.point_error[k] + 7.1f * 0x1p-23f * ex,
                                 2.01f * set.point_error[l] + 7.1f * 0x1p-23f * ey};
        const Ints is_judged = (ex < extent_max) & (ey < extent_max);
        open = ~(find_parted(p, q, error) & is_judged);
        if (any_bits(open) != 0) open &= ~(find_parted(q, p, error) & is_judged);
    }
};
