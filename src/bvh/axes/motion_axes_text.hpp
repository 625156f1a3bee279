// bvh/axes/motion_axes.cpp includes this source once for each instruction set.

ECODS_ALWAYS_INLINE Matrix4 middle(const Edges& start, const Edges& end) noexcept {
    Matrix4 result;
    for (int i = 0; i < 3; ++i) result.column[i] = 0.5 * start.edges.column[i] + 0.5 * end.edges.column[i];
    return result;
}

// Binds the first set to the face normals of a's boxes, and the second to the face normals of b's boxes, half-way
// through the motion. Returns these normals.
ECODS_ALWAYS_INLINE std::array<Matrix4, 2> bind_sets(std::array<MotionSet, 2>& sets, const MovingTree& a,
                                                     const MovingTree& b, const Vec3& d_from,
                                                     const Vec3& d_to) noexcept {
    const Edges a_from(a.frame_from, a.from), a_to(a.frame_to, a.to);
    const Edges b_from(b.frame_from, b.from), b_to(b.frame_to, b.to);
    const Matrix4 a_middle = middle(a_from, a_to), b_middle = middle(b_from, b_to);
    const Double4 d0 = load3(d_from.data()), d1 = load3(d_to.data());
    const Matrix4 normals_a = axes_of(a_middle, b_middle), normals_b = axes_of(b_middle, a_middle);
    set_floats(sets[0].start, DoubleAxes(normals_a, a_from, b_from, d0, Own::a));
    set_floats(sets[0].end, DoubleAxes(normals_a, a_to, b_to, d1, Own::a));
    set_floats(sets[1].start, DoubleAxes(normals_b, a_from, b_from, d0, Own::b));
    set_floats(sets[1].end, DoubleAxes(normals_b, a_to, b_to, d1, Own::b));
    return {normals_a, normals_b};
}

// Adds a distance in the world to the reach of b's boxes on three axes.
ECODS_ALWAYS_INLINE void widen(AxisSet& set, const Matrix4& normals, double margin) noexcept {
    const Double4 square = (normals.column[0] * normals.column[0] + normals.column[1] * normals.column[1]) +
                           normals.column[2] * normals.column[2];
    for (std::size_t k = 0; k < 3; ++k) {
        const double added = margin * std::sqrt(square[static_cast<int>(k)]);
        set.b.margin[k] = static_cast<float>((static_cast<double>(set.b.margin[k]) + added) * (1 + 0x1p-22));
    }
}

[[gnu::noinline]] inline void bind_motion_sets(std::array<MotionSet, 2>& sets, const MovingTree& a, const MovingTree& b,
                                               const Vec3& d_from, const Vec3& d_to) noexcept {
    bind_sets(sets, a, b, d_from, d_to);
}

[[gnu::noinline]] inline void bind_near_motion_sets(std::array<MotionSet, 2>& sets, const MovingTree& a,
                                                    const MovingTree& b, const Vec3& d_from, const Vec3& d_to,
                                                    double margin) noexcept {
    const std::array<Matrix4, 2> normals = bind_sets(sets, a, b, d_from, d_to);
    for (std::size_t i = 0; i < 2; ++i) {
        widen(sets[i].start, normals[i], margin);
        widen(sets[i].end, normals[i], margin);
    }
}
