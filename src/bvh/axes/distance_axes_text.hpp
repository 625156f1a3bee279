// bvh/axes/distance_axes.cpp includes this source once for each instruction set.

inline constexpr double tau_max = 0x1p-7;     // with a larger tau, bounds would be too loose
inline constexpr double square_max = 0x1p55;  // upper bound of coordinates that are squared

// Returns the largest power of two that is at most x, clamped to [2^-900, 2^900]; 1 if x is 0.
ECODS_ALWAYS_INLINE double power_of_two(double x) noexcept {
    if (!(x > 0)) return 1;
    const double clamped = std::min(std::max(x, 0x1p-900), 0x1p900);
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(clamped) & 0x7ff0000000000000u);
}

ECODS_ALWAYS_INLINE Matrix4 operator*(const Matrix4& m, double x) noexcept {
    return {{m.column[0] * x, m.column[1] * x, m.column[2] * x}};
}

// Holds nearly orthogonal axes N, in units. The eigenvalues of N N^T are between factor / (1 + tau) and factor (1 +
// tau).
struct EvenAxes {
    Matrix4 N;
    double factor;
    double tau;
};

// Returns the face normals of a box with the edges `own`, if they are nearly orthogonal and of nearly one length;
// otherwise the axes of the world.
ECODS_ALWAYS_INLINE EvenAxes even_axes(const Matrix4& own, const Matrix4& other) noexcept {
    const Matrix4 N = axes_of(own, other);
    const Matrix4 rows = transpose(N);
    const Double4 x = rows.column[0], y = rows.column[1], z = rows.column[2];
    const double xx = dot(x, x), yy = dot(y, y), zz = dot(z, z);
    const double factor = ((xx + yy) + zz) / 3;
    const double xy = std::abs(dot(x, y)), yz = std::abs(dot(y, z)), zx = std::abs(dot(z, x));
    const double worst = std::max(
        {(std::abs(xx - factor) + xy) + zx, (std::abs(yy - factor) + xy) + yz, (std::abs(zz - factor) + yz) + zx});
    const double tau = worst / factor + 0x1p-40;
    if (tau <= tau_max && factor > 0x1p-5 && factor < 0x1p100) return {N, factor, tau};
    return {{{Double4{1, 0, 0, 0}, Double4{0, 1, 0, 0}, Double4{0, 0, 1, 0}}}, 1, 0};
}

ECODS_ALWAYS_INLINE void bind_set(DistanceSet& set, const EvenAxes& even, const Edges& edges_a, const Edges& edges_b,
                                  Double4 d, Own own, double unit) noexcept {
    const DoubleAxes exact(even.N * (1 / unit), edges_a, edges_b, d, own);
    set_floats(set.axes, exact);
    // If the sum is NaN, the comparison is false, and the set becomes unbounded.
    if (!(sum(exact.s) < square_max)) {
        set.axes.set_unbounded();
    }
    set.square = round_down((1 - even.tau) / even.factor * (1 - 0x1p-18));
    set.square_up = round_up((1 + 2 * even.tau) / even.factor * (1 + 0x1p-18));
}

[[gnu::noinline]] inline double bind_point_set(DistanceSet& set, const PosedTree& tree, const Vec3& d) noexcept {
    const Edges point, edges(tree.tree.frame, tree.R);
    const double unit = power_of_two(largest(absolute(edges.edges)));
    const Matrix4 own = edges.edges * (1 / unit);
    bind_set(set, even_axes(own, own), point, edges, load3(d.data()), Own::b, unit);
    return unit;
}

[[gnu::noinline]] inline double bind_distance_sets(std::array<DistanceSet, 2>& sets, const PosedTree& a,
                                                   const PosedTree& b, const Vec3& difference) noexcept {
    const Edges edges_a(a.tree.frame, a.R), edges_b(b.tree.frame, b.R);
    const Double4 d = load3(difference.data());
    const double unit = power_of_two(std::max(largest(absolute(edges_a.edges)), largest(absolute(edges_b.edges))));
    const Matrix4 own_a = edges_a.edges * (1 / unit), own_b = edges_b.edges * (1 / unit);
    bind_set(sets[0], even_axes(own_a, own_b), edges_a, edges_b, d, Own::a, unit);
    bind_set(sets[1], even_axes(own_b, own_a), edges_a, edges_b, d, Own::b, unit);
    return unit;
}
