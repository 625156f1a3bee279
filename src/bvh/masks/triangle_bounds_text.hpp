// bvh/masks/triangle_bounds.cpp includes this source once for each instruction set.

// Bounds the distance of one pair of triangles a and b in each lane. Any two points of the triangles give an upper
// bound; two close points are guessed. The vector n from one point to the other gives a lower bound: all points of b
// have n . y >= min n . b, and all points of a have n . x <= max n . a, so the distance is at least (min n . b - max n
// . a) / |n|.
//
// Bound. Let E = `error`, which is an error bound of a corner, and at least 8 v |z| for all coordinates z, v = 2^-23.
// Upper bound: a point of an edge is z + t e with 0 <= t <= 1. The difference e is off by 2 v |z|, product and sum by 5
// v |z|: together below E. The errors of the corners add E. A point of a face is z + (t e - u e'), where t and u are
// not negative and t + u is at most 1 + v. In units of v |z| the differences cost 4, the products 4, their sum 4, the
// last sum 5, and the excess of t + u 2: together below 2.4 E. The errors of the corners add E. So n, the difference of
// two points as computed, is off by less than 4.5 E on each axis besides its own rounding v, and its length by 8 E;
// squares, sums and root are 4 v. 9 E has a margin for the rest.
//
// Lower bound: n and p, the point from which the corners are measured, may be any floats, so they have no errors. A
// corner is off by E, its difference from p by v M and the product with n by 3.01 v M, where M is the largest
// coordinate of a difference: together sum |n_k| (E + 4.01 v M). Two such errors, and the rounding of M, make 2 E + 9 v
// M. The difference, its square, n . n, the quotient and the factor are below 10 v, relative, and 2^-18 of `square`
// covers them together with the errors of near_mask().
// Claim: verify/proofs/small_bounds.py
struct BoundsKernel : ProjectedLanes<float_width> {
    struct Vector {
        Floats x, y, z;
    };
    ECODS_ALWAYS_INLINE static Vector sub(const Vector& a, const Vector& b) noexcept {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    // Returns a + t b.
    ECODS_ALWAYS_INLINE static Vector along(const Vector& a, Floats t, const Vector& b) noexcept {
        return {a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
    }
    ECODS_ALWAYS_INLINE static Floats dot(const Vector& a, const Vector& b) noexcept {
        return (a.x * b.x + a.y * b.y) + a.z * b.z;
    }
    ECODS_ALWAYS_INLINE static Vector cross(const Vector& a, const Vector& b) noexcept {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    ECODS_ALWAYS_INLINE static Vector scale(Floats t, const Vector& a) noexcept { return {t * a.x, t * a.y, t * a.z}; }
    ECODS_ALWAYS_INLINE static Vector select(Ints mask, const Vector& a, const Vector& b) noexcept {
        return {ECODS_SET::select(mask, a.x, b.x), ECODS_SET::select(mask, a.y, b.y),
                ECODS_SET::select(mask, a.z, b.z)};
    }
    // Clamps t to [0, 1]; NaN becomes 0.
    ECODS_ALWAYS_INLINE static Floats clamp(Floats t) noexcept { return min(max(t, Floats{}), broadcast<Floats>(1)); }

    // Holds a triangle in each lane: its corners, the edges from each corner to the next, and values computed from
    // these.
    struct Triangles {
        Vector v[3], e[3];
        Floats length[3], inverse[3];  // squared lengths of the edges, and their reciprocals
        Vector u, w;                   // the foot of v[0] + r on the plane is v[0] + (u . r) e[0] - (w . r) e[2]

        ECODS_ALWAYS_INLINE void find_edges() noexcept {
            for (int i = 0; i < 3; ++i) {
                e[i] = sub(v[(i + 1) % 3], v[i]);
                length[i] = dot(e[i], e[i]);
                inverse[i] = 1 / length[i];
            }
            const Vector n = cross(e[2], e[0]);
            const Floats inverse_n = 1 / dot(n, n);
            // u is e' x n / n . n, and w is n x e / n . n, where e = e[0] and e' = -e[2].
            u = scale(inverse_n, cross(n, e[2]));
            w = scale(inverse_n, cross(n, e[0]));
        }
    };

    // Holds the closest two points found so far in each lane: `from` in triangle a, and from + n in triangle b.
    struct Closest {
        Floats square;
        Vector n{}, from{};

        ECODS_ALWAYS_INLINE Closest() noexcept : square(broadcast<Floats>(std::numeric_limits<float>::infinity())) {}

        ECODS_ALWAYS_INLINE void take(const Vector& p, const Vector& q, Ints valid) noexcept {
            const Vector r = sub(q, p);
            const Floats d = dot(r, r);
            const Ints closer = (d < square) & valid;
            square = ECODS_SET::select(closer, d, square);
            n = select(closer, r, n);
            from = select(closer, p, from);
        }
    };

    ECODS_ALWAYS_INLINE static void try_edges(const Triangles& a, const Triangles& b, Closest& closest) noexcept {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const Vector r = sub(a.v[i], b.v[j]);
                const Floats f = dot(b.e[j], r), c = dot(a.e[i], r), m = dot(a.e[i], b.e[j]);
                const Floats den = a.length[i] * b.length[j] - m * m;
                Floats s = clamp((m * f - c * b.length[j]) / den);
                const Floats t = clamp((m * s + f) * b.inverse[j]);
                s = clamp((m * t - c) * a.inverse[i]);
                closest.take(along(a.v[i], s, a.e[i]), along(b.v[j], t, b.e[j]), ~Ints{});
            }
        }
    }

    // Returns the foot of `point` on the plane of the face, and sets `inside` to the lanes in which it is in the face.
    // The foot is computed as a combination of corners, so it stays near a slender triangle even if the weights are
    // inaccurate. The point minus a multiple of the normal might not.
    ECODS_ALWAYS_INLINE static Vector foot(const Triangles& face, const Vector& point, Ints& inside) noexcept {
        const Vector r = sub(point, face.v[0]);
        const Floats t = dot(face.u, r), u = dot(face.w, r);
        inside = (t >= 0) & (u >= 0) & (t + u <= 1);
        return {face.v[0].x + (t * face.e[0].x - u * face.e[2].x), face.v[0].y + (t * face.e[0].y - u * face.e[2].y),
                face.v[0].z + (t * face.e[0].z - u * face.e[2].z)};
    }

    ECODS_ALWAYS_INLINE static void try_faces(const Triangles& a, const Triangles& b, Closest& closest) noexcept {
        for (int i = 0; i < 3; ++i) {
            Ints inside;
            const Vector on_a = foot(a, b.v[i], inside);
            closest.take(on_a, b.v[i], inside);
            const Vector on_b = foot(b, a.v[i], inside);
            closest.take(a.v[i], on_b, inside);
        }
    }

    ECODS_ALWAYS_INLINE static Floats largest(const Vector& r) noexcept {
        return max(absolute(r.x), max(absolute(r.y), absolute(r.z)));
    }

    ECODS_ALWAYS_INLINE static Floats lower_square(const Triangles& a, const Triangles& b, const Closest& closest,
                                                   float error, float square) noexcept {
        const Vector& n = closest.n;
        Floats high{}, low{}, size{};
        for (int i = 0; i < 3; ++i) {
            const Vector ra = sub(a.v[i], closest.from), rb = sub(b.v[i], closest.from);
            const Floats at_a = dot(n, ra), at_b = dot(n, rb);
            high = i == 0 ? at_a : max(high, at_a);
            low = i == 0 ? at_b : min(low, at_b);
            size = max(size, max(largest(ra), largest(rb)));
        }
        const Floats sum = (absolute(n.x) + absolute(n.y)) + absolute(n.z);
        const Floats gap = max((low - high) - sum * (2 * error + 9 * 0x1p-23f * size), Floats{});
        // If n is shorter than this, its square loses digits to underflow, and the bound is 0. The order of operations
        // avoids the square of the gap, which may overflow.
        const Ints is_long = closest.square > 0x1p-80f;
        return ECODS_SET::select(is_long, gap * (gap / closest.square) * square, Floats{});
    }

    ECODS_ALWAYS_INLINE static void gather(Triangles& t, const AxisCorners& from, std::size_t part) noexcept {
        for (std::size_t c = 0; c < 3; ++c) {
            t.v[c] = {load(from[c][0], part), load(from[c][1], part), load(from[c][2], part)};
        }
        t.find_edges();
    }

    [[gnu::noinline]] static void bound(const DistanceSet& set, const TriangleBatch& batch,
                                        TriangleSquares& squares) noexcept {
        const auto& errors = set.axes.point_error;
        const float error = std::max(std::max(errors[0], errors[1]), errors[2]);
        for (std::size_t part = 0; part < part_count && part * float_width < batch.count; ++part) {
            Triangles a, b;
            gather(a, batch.a, part);
            gather(b, batch.b, part);
            Closest closest;
            try_edges(a, b, closest);
            try_faces(a, b, closest);
            store(squares.lower, part, lower_square(a, b, closest, error, set.square));
            store(squares.upper, part, closest.square);
            store(squares.between[0], part, closest.n.x);
            store(squares.between[1], part, closest.n.y);
            store(squares.between[2], part, closest.n.z);
        }
    }

    [[gnu::noinline]] static void put(const DistanceSet& set, const TreeLeaf& x, const TreeLeaf& y,
                                      LeavesOnAxes& leaves) noexcept {
        Corners corners;
        pose(set.axes.a, x, corners);
        leaves.x = corners.at;
        pose(set.axes.b, y, corners);
        leaves.y = corners.at;
    }
};
