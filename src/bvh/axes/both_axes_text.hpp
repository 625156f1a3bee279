// bvh/axes/separating_axes.cpp includes this source for AVX-512. The code projects two posed trees on the face normals
// of both trees at once: AxesOf in registers of eight doubles. The first four lanes are for the set of a's normals, and
// the last four for the set of b's. Poses must be rotations, up to rounding, and numbers within their limits.

ECODS_ALWAYS_INLINE Matrix<Double8> transpose(const Matrix<Double8>& m) noexcept {
    const Double8 low = even_lanes(m.column[0], m.column[1]);
    const Double8 high = odd_lanes(m.column[0], m.column[1]);
    const auto z = m.column[2];
    return {{lanes_of<0, 1, 8, 11, 4, 5, 12, 15>(low, z), lanes_of<0, 1, 9, 11, 4, 5, 13, 15>(high, z),
             lanes_of<2, 3, 10, 11, 6, 7, 14, 15>(low, z)}};
}
ECODS_ALWAYS_INLINE Matrix<Double8> swapped(const Matrix<Double8>& m) noexcept {
    return {{swapped(m.column[0]), swapped(m.column[1]), swapped(m.column[2])}};
}
ECODS_ALWAYS_INLINE Double8 distance_from_identity(const Matrix<Double8>& m) noexcept {
    const Double4 x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0};
    return row_sums(Matrix<Double8>{
        {absolute(m.column[0] - join(x, x)), absolute(m.column[1] - join(y, y)), absolute(m.column[2] - join(z, z))}});
}
ECODS_ALWAYS_INLINE Matrix<Double8> load_both(const Mat3& a, const Mat3& b) noexcept {
    return {{load_three(a.data(), b.data()), load_three(a.data() + 3, b.data() + 3),
             load_three(a.data() + 6, b.data() + 6)}};
}
ECODS_ALWAYS_INLINE Matrix4 low_half(const Matrix<Double8>& m) noexcept {
    return {{low_half(m.column[0]), low_half(m.column[1]), low_half(m.column[2])}};
}
ECODS_ALWAYS_INLINE Matrix4 high_half(const Matrix<Double8>& m) noexcept {
    return {{high_half(m.column[0]), high_half(m.column[1]), high_half(m.column[2])}};
}

ECODS_ALWAYS_INLINE EdgesOf<Double8> edges_of_both(const PosedTree& a, const PosedTree& b) noexcept {
    const LocalFrame &x = a.tree.frame, &y = b.tree.frame;
    return {load_both(a.R, b.R),
            load_both(x.map, y.map),
            load_three(x.map_size.data(), y.map_size.data()),
            load_three(x.center.data(), y.center.data()),
            both(x.size_max, y.size_max),
            both(x.scale, y.scale)};
}
ECODS_ALWAYS_INLINE EdgesOf<Double8> swapped(const EdgesOf<Double8>& edges) noexcept {
    EdgesOf<Double8> result;
    result.edges = swapped(edges.edges);
    result.size = swapped(edges.size);
    result.origin = swapped(edges.origin);
    result.origin_size = swapped(edges.origin_size);
    result.factor = swapped(edges.factor);
    result.scale = swapped(edges.scale);
    return result;
}
ECODS_ALWAYS_INLINE AxesOf<Double8> axes_of_both(const EdgesOf<Double8>& edges, const Vec3& difference) noexcept {
    const Matrix<Double8> N = normals_along<Double8>(edges);
    const Double8 d = load_three(difference.data(), difference.data());
    const Double8 between = halves<1, 1>(edges.origin) - halves<0, 0>(edges.origin);
    return {N, N * edges.edges, edges, swapped(edges), between + d, absolute(d)};
}

// Provides the tests that find_axis() calls, with both sets computed at once. For both trees P must be the identity, up
// to rounding.
struct BothBoxes {
    const AxesOf<Double8>& axes;
    RootBox root_a, root_b;
    Double8 other_half;   // reach of the box of the other tree, whose normals the axes are not
    std::uint32_t faces;  // bits of the normals that separate the roots: 0 to 2 for a's, 4 to 6 for b's

    ECODS_ALWAYS_INLINE BothBoxes(const AxesOf<Double8>& of, const MeshBvh& a, const MeshBvh& b) noexcept
        : axes(of), root_a(a), root_b(b) {
        const Double8 center = load_three(a.root_center.data(), b.root_center.data()),
                      half = load_three(a.root_half.data(), b.root_half.data());
        const Double8 signs = join(Double4{}, broadcast<Double4>(-0.0));
        other_half = absolute(axes.other) * swapped(half);
        const Double8 distance = absolute((center - axes.other * swapped(center)) - flip(axes.offset, signs));
        const Double8 reach = (half + other_half) + axes.margin;
        faces = is_greater(distance, reach) & 0x77u;
    }

    ECODS_ALWAYS_INLINE int face_of_a() const noexcept { return (faces & 7) != 0 ? std::countr_zero(faces) : -1; }
    ECODS_ALWAYS_INLINE int face_of_b() const noexcept { return faces > 7 ? std::countr_zero(faces >> 4) : -1; }
    ECODS_ALWAYS_INLINE int edges() const noexcept {
        return separating_edges(low_half(axes.other), low_half(axes.offset), low_half(axes.margin), root_a, root_b);
    }
    template <class Half>
    ECODS_ALWAYS_INLINE void set_half(AxisSet& set, Own own, const Half& half) const noexcept {
        DoubleAxes exact;
        exact.other = half(axes.other);
        exact.offset = half(axes.offset);
        exact.s = half(axes.s);
        exact.w = half(axes.w);
        exact.e = half(axes.e);
        exact.own_tree = own;
        exact.is_unit = exact.is_bounded = true;
        set_floats(set, exact);
    }
    ECODS_ALWAYS_INLINE void set(std::array<AxisSet, 2>& sets) const noexcept {
        set_half(sets[0], Own::a, [](const auto& of_both) { return low_half(of_both); });
        set_half(sets[1], Own::b, [](const auto& of_both) { return high_half(of_both); });
        sets[0].flat_axis = find_flat_axis(root_a.half, low_half(other_half));
    }
};

[[gnu::noinline]] inline int bind_both_axis_sets(std::array<AxisSet, 2>& sets, const PosedTree& a, const PosedTree& b,
                                                 const Vec3& difference, int preferred) noexcept {
    const AxesOf<Double8> axes = axes_of_both(edges_of_both(a, b), difference);
    if (!axes.is_unit || !axes.is_bounded) return avx2::bind_axis_sets(sets, a, b, difference, preferred);
    BothBoxes boxes(axes, a.tree, b.tree);
    return find_axis(boxes, sets, preferred);
}
