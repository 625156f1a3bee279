// bvh/axes/swept_axes.cpp includes this source once for each instruction set.

// Narrows the window to the times at which the roots' projections overlap on all three axes. A time that is NaN changes
// nothing.
ECODS_ALWAYS_INLINE void narrow(SweptWindow& window, const DoubleAxes& set, Double4 velocity, const RootBox& a,
                                const RootBox& b) noexcept {
    const Double4 apart = (set.b() * b.center + set.offset) - set.a() * a.center;
    const Double4 reach = (absolute(set.a()) * a.half + absolute(set.b()) * b.half) + set.margin;
    for (int k = 0; k < 3; ++k) {
        const double v = std::abs(velocity[k]), from = velocity[k] < 0 ? -apart[k] : apart[k];
        const double begin = (from - reach[k]) / v * (1 - 0x1p-40), end = (from + reach[k]) / v * (1 + 0x1p-40);
        if (from - reach[k] > 0) window.begin = std::max(window.begin, std::min(begin, 0x1p1000));
        if (from + reach[k] < 0) window.end = -1;
        if (end < window.end) window.end = end;
    }
}

struct Sweep {
    Edges a, b;
    Matrix4 normals[2];
    RootBox root_a, root_b;

    ECODS_ALWAYS_INLINE Sweep(const PosedTree& tree_a, const PosedTree& tree_b) noexcept
        : a(tree_a.tree.frame, tree_a.R),
          b(tree_b.tree.frame, tree_b.R),
          normals{axes_of(a.edges, b.edges), axes_of(b.edges, a.edges)},
          root_a(tree_a.tree),
          root_b(tree_b.tree) {}

    ECODS_ALWAYS_INLINE DoubleAxes axes_of_set(std::size_t set, Double4 d, Double4 d_size,
                                               Double4 velocity) const noexcept {
        return {normals[set], a, b, d, d_size, absolute(velocity), set == 0 ? Own::a : Own::b};
    }
};

[[gnu::noinline]] inline SweptWindow bind_swept_sets(std::array<SweptSet, 2>& sets, const PosedTree& a,
                                                     const PosedTree& b, const Vec3& difference, const Vec3& motion,
                                                     double latest) noexcept {
    const Sweep sweep(a, b);
    const Double4 d = load3(difference.data()), m = load3(motion.data());
    SweptWindow window{0, latest};
    for (std::size_t i = 0; i < 2; ++i) {
        const Double4 velocity = sweep.normals[i] * m;
        const DoubleAxes axes = sweep.axes_of_set(i, d, absolute(d) + absolute(m), velocity);
        narrow(window, axes, velocity, sweep.root_a, sweep.root_b);
    }
    if (window.begin > window.end) return {1, 0};
    const double start = window.begin * (1 - 0x1p-40);
    const double length = (window.end - start) * (1 + 0x1p-40) + (window.end * 0x1p-40 + 0x1p-1000);
    const Double4 before = m * start, path = m * length;
    const Double4 d_size = (absolute(d) + absolute(before)) + absolute(path);
    for (std::size_t i = 0; i < 2; ++i) {
        const Double4 velocity = sweep.normals[i] * path;
        const DoubleAxes axes = sweep.axes_of_set(i, d - before, d_size, velocity);
        set_floats(sets[i].axes, axes);
        sets[i].velocity = to_floats(velocity);
    }
    return {start, length};
}
