// bvh/masks/overlap_mask.cpp includes this source once for each instruction set.

template <class Number>
struct LaneVector {
    Number x, y, z;
};
template <class Number>
ECODS_ALWAYS_INLINE LaneVector<Number> operator-(const LaneVector<Number>& a, const LaneVector<Number>& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// TriangleLanes finds pairs of triangles that are proven disjoint, or proven to cross, in the coordinates of the axes.
// These coordinates are a linear map of world coordinates. Triangles that are apart in these coordinates are disjoint
// in the world. If the map is a bijection, triangles that cross in these coordinates cross in the world, too.
struct TriangleLanes : ProjectedLanes<float_width> {
    static constexpr float extent_max = 0x1p40f;

    template <class Number>
    using Vector = LaneVector<Number>;
    using Vectors = Vector<Floats>;  // one vector in each lane

    template <class Number>
    ECODS_ALWAYS_INLINE static Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) noexcept {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    template <class A, class B>
    ECODS_ALWAYS_INLINE static Floats dot(const Vector<A>& a, const Vector<B>& b) noexcept {
        return (a.x * b.x + a.y * b.y) + a.z * b.z;
    }
    ECODS_ALWAYS_INLINE static Floats least_of(const Floats (&v)[3]) noexcept { return min(v[0], min(v[1], v[2])); }
    ECODS_ALWAYS_INLINE static Floats most_of(const Floats (&v)[3]) noexcept { return max(v[0], max(v[1], v[2])); }

    // Returns corner c of the triangle in each lane.
    ECODS_ALWAYS_INLINE static Vectors corner(const Corners& corners, std::size_t c, std::size_t part) noexcept {
        const auto& at = corners.at[c];
        return {load(at[0], part), load(at[1], part), load(at[2], part)};
    }
    // Returns corner c of triangle i in all lanes.
    ECODS_ALWAYS_INLINE static Vectors corner_of(const Corners& corners, std::size_t c, std::size_t i) noexcept {
        const auto& at = corners.at[c];
        return {broadcast<Floats>(at[0][i]), broadcast<Floats>(at[1][i]), broadcast<Floats>(at[2][i])};
    }

    ECODS_ALWAYS_INLINE static Vectors choose(Ints mask, const Vectors& yes, const Vectors& no) noexcept {
        return {select<Floats>(mask, yes.x, no.x), select<Floats>(mask, yes.y, no.y),
                select<Floats>(mask, yes.z, no.z)};
    }
    ECODS_ALWAYS_INLINE static void swap_where(Ints mask, Vectors& a, Vectors& b) noexcept {
        const Vectors old = a;
        a = choose(mask, b, a);
        b = choose(mask, old, b);
    }

    // Rotates the corners p in each lane such that the apex, the corner that is alone on its side of a plane, comes
    // first. `sides` must have two numbers of one sign and one of the other. Returns the lanes in which the apex is on
    // the negative side.
    ECODS_ALWAYS_INLINE static Ints put_apex_first(const Floats (&sides)[3], Vectors (&p)[3]) noexcept {
        const Ints n0 = sides[0] < Floats{}, n1 = sides[1] < Floats{}, n2 = sides[2] < Floats{};
        const Ints first = ~(n1 ^ n2), second = ~(n0 ^ n2);
        const Vectors apex = choose(first, p[0], choose(second, p[1], p[2])),
                      next = choose(first, p[1], choose(second, p[2], p[0])),
                      last = choose(first, p[2], choose(second, p[0], p[1]));
        p[0] = apex;
        p[1] = next;
        p[2] = last;
        return (first & n0) | (~first & ((second & n1) | (~second & n2)));
    }

    // Sets `apart` to the lanes whose pairs are certainly disjoint, and `crossing` to the lanes whose pairs certainly
    // cross. All corners of each triangle must certainly be off the plane of the other one, and not all on one side.
    // p_sides are the sides of the corners p relative to q's plane, and q_sides the reverse. Compares edges along the
    // line of the two planes twice, as exact/simplex/triangle_pair.hpp derives.
    ECODS_ALWAYS_INLINE static void compare_edges(Vectors (&p)[3], const Floats (&p_sides)[3], Vectors (&q)[3],
                                                  const Floats (&q_sides)[3], Floats bound, Ints& apart,
                                                  Ints& crossing) noexcept {
        const Ints p_is_below = put_apex_first(p_sides, p), q_is_below = put_apex_first(q_sides, q);
        swap_where(p_is_below, q[1], q[2]);
        swap_where(q_is_below, p[1], p[2]);
        const Floats begin = dot(cross(q[0] - p[1], p[0] - p[1]), q[1] - p[1]),
                     end = dot(cross(q[0] - p[0], p[2] - p[0]), q[2] - p[0]);
        apart = (begin > bound) | (end > bound);
        crossing = (begin < -bound) & (end < -bound);
    }

    // Holds two sets of pairs of triangles of leaves x and y: bit i in lane j is for triangle i of x and triangle j of
    // y.
    struct Found {
        Ints near;      // not proven disjoint
        Ints crossing;  // pairs in `near` that are proven to cross in the coordinates of the corners
    };

    // Holds the normals of the eight triangles of a leaf x.
    struct Normals {
        alignas(32) std::array<FloatLanes, 3> at;

        ECODS_ALWAYS_INLINE explicit Normals(const Corners& x) noexcept {
            for (std::size_t part = 0; part < part_count; ++part) {
                const Vectors p = corner(x, 0, part);
                const Vectors n = cross(corner(x, 1, part) - p, corner(x, 2, part) - p);
                store(at[0], part, n.x);
                store(at[1], part, n.y);
                store(at[2], part, n.z);
            }
        }
    };

    // Returns the pairs in `near` that are not proven disjoint, and the pairs that are proven to cross. Each lane has
    // one pair: a triangle p with normal n, and a triangle q with normal m. If p is the same in all lanes, n has
    // scalars instead of lanes. `extent` is, by axis, the length of the interval that contains both triangles, and
    // `delta` the error bound of a corner.
    //
    // Bound, with v = 2^-23, d the error of a corner and E the extents of both triangles. Rounding: differences and the
    // determinant of exact/sign/filter_bound.hpp, with v for u', are off by less than 46.01 v ExEyEz. Input errors:
    // with columns divided by E, entries are at most 1 and errors at most t_k = 2 d_k / E_k. A determinant of three
    // columns of entries up to x, y and z is at most 4 x y z, so these errors change it by at most
    //     4 ((tx + ty + tz) + (tx ty + tx tz + ty tz) + tx ty tz).
    // The bound below has 6.25 (tx + ty + tz). A sign is certain only if the computed determinant, which is at most 4,
    // exceeds this bound. Then tx + ty + tz is below 0.65, so the terms of higher order raise the factor 4 of tx + ty +
    // tz to less than 5. 49 v also covers the bound's own evaluation. (Extents are not enlarged by d: spans of the
    // first tree have no margin.) Overflow: none for extents below 2^40. Triangles with an extent of 2^40 or more stay
    // undecided. (A mode that rounds down may turn a determinant into -infinity, and the bound only into the largest
    // float.) Underflow: a product of three numbers loses 2^-126 times an extent. The extents that matter are near one,
    // since coordinates that decide are below 4 in size, or delta is above 2^-20 of them. 2^-100 is added.
    // Claim: verify/proofs/float_determinants.py
    template <class NormalOfP>
    ECODS_ALWAYS_INLINE static Found decide(const std::array<float, 4>& delta, const Vectors (&p)[3],
                                            const NormalOfP& n, const Vectors (&q)[3], const Vectors& m,
                                            const Vectors& extent, const Ints& near) noexcept {
        const Floats ex = extent.x, ey = extent.y, ez = extent.z;
        const Floats bound = ex * ey * (49 * 0x1p-23f * ez + 12.5f * delta[2]) +
                             ez * (12.5f * delta[0] * ey + 12.5f * delta[1] * ex) + 0x1p-100f;
        Floats q_sides[3], p_sides[3];
        for (std::size_t c = 0; c < 3; ++c) {
            q_sides[c] = dot(n, q[c] - p[0]);
            p_sides[c] = dot(m, p[c] - q[0]);
        }
        const Ints apart = (least_of(q_sides) > bound) | (most_of(q_sides) < -bound) | (least_of(p_sides) > bound) |
                           (most_of(p_sides) < -bound);
        const Ints is_judged = (ex < extent_max) & (ey < extent_max) & (ez < extent_max);
        Found found{~(apart & is_judged) & near, {}};
        if (any_bits(found.near) == 0) return found;
        const auto are_certain = [&](const Floats(&s)[3]) -> Ints {
            return min(absolute(s[0]), min(absolute(s[1]), absolute(s[2]))) > bound;
        };
        const Ints are_clear = are_certain(q_sides) & are_certain(p_sides) & is_judged;
        if (any_bits(found.near & are_clear) == 0) return found;
        Vectors p_named[3] = {p[0], p[1], p[2]}, q_named[3] = {q[0], q[1], q[2]};
        Ints edges_part, edges_cross;
        compare_edges(p_named, p_sides, q_named, q_sides, bound, edges_part, edges_cross);
        found.near &= ~(edges_part & are_clear);
        found.crossing = found.near & edges_cross & are_clear;
        return found;
    }

    // Returns the result of decide() for the pairs in `near`. `rows` must contain all bits that lanes of `near` have.
    ECODS_ALWAYS_INLINE static Found find(const std::array<float, 4>& delta, const Corners& x, const Spans& x_spans,
                                          const Normals& x_normals, const Corners& y, const Spans& y_spans,
                                          std::size_t part, Ints near, std::uint32_t rows) noexcept {
        const Vectors q[3] = {corner(y, 0, part), corner(y, 1, part), corner(y, 2, part)};
        const Vectors m = cross(q[1] - q[0], q[2] - q[0]);
        Found found{};
        for (; rows != 0; rows &= rows - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rows));
            const auto extent = [&](std::size_t k) -> Floats {
                const auto low = broadcast<Floats>(x_spans.low[k][i]), high = broadcast<Floats>(x_spans.high[k][i]);
                return max(high, load(y_spans.high[k], part)) - min(low, load(y_spans.low[k], part));
            };
            const Vectors p[3] = {corner_of(x, 0, i), corner_of(x, 1, i), corner_of(x, 2, i)};
            const Vector<float> n{x_normals.at[0][i], x_normals.at[1][i], x_normals.at[2][i]};
            const Found more = decide(delta, p, n, q, m, {extent(0), extent(1), extent(2)}, near & (1 << i));
            found.near |= more.near;
            found.crossing |= more.crossing;
        }
        return found;
    }
};
