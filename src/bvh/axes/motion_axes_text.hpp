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

// Returns the squares of |n x e| for three axes n, the rows of `normals`, and the vector e = `axis`.
ECODS_ALWAYS_INLINE Double4 squares_across(const Matrix4& normals, const Vec3& axis) noexcept {
    const Double4 &x = normals.column[0], &y = normals.column[1], &z = normals.column[2];
    const double* const e = axis.data();
    const Double4 over_x = y * e[2] - z * e[1], over_y = z * e[0] - x * e[2], over_z = x * e[1] - y * e[0];
    return (over_x * over_x + over_y * over_y) + over_z * over_z;
}

// Enlarges the reach of b's boxes on three axes by `margin`, which is given in the world. Rounding of products is
// within margin.everywhere.
ECODS_ALWAYS_INLINE void widen(AxisSet& set, const Matrix4& normals, const MotionMargin& margin) noexcept {
    const Double4 &x = normals.column[0], &y = normals.column[1], &z = normals.column[2];
    const double* const m = margin.along.data();
    const Double4 square = (x * x + y * y) + z * z, along = (x * m[0] + y * m[1]) + z * m[2];
    const MotionMargin::Across &first = margin.across[0], &second = margin.across[1];
    const Double4 of_first = squares_across(normals, first.axis), of_second = squares_across(normals, second.axis);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(k);
        const double across = first.most * std::sqrt(of_first[i]) + second.most * std::sqrt(of_second[i]);
        const double added = margin.everywhere * std::sqrt(square[i]) + (across + std::abs(along[i]));
        set.b.margin[k] = static_cast<float>((static_cast<double>(set.b.margin[k]) + added) * (1 + 0x1p-22));
    }
}

[[gnu::noinline]] inline void bind_motion_sets(std::array<MotionSet, 2>& sets, const MovingTree& a, const MovingTree& b,
                                               const Vec3& d_from, const Vec3& d_to) noexcept {
    bind_sets(sets, a, b, d_from, d_to);
}

[[gnu::noinline]] inline void bind_near_motion_sets(std::array<MotionSet, 2>& sets, const MovingTree& a,
                                                    const MovingTree& b, const Vec3& d_from, const Vec3& d_to,
                                                    const MotionMargin& margin) noexcept {
    const std::array<Matrix4, 2> normals = bind_sets(sets, a, b, d_from, d_to);
    MotionMargin at_end = margin;
    at_end.everywhere += margin.later;
    for (std::size_t i = 0; i < 2; ++i) {
        widen(sets[i].start, normals[i], margin);
        widen(sets[i].end, normals[i], at_end);
    }
}
