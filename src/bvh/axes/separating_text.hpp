// bvh/axes/separating_axes.cpp includes this source once for each instruction set.

// Returns the row, 0 to 2, of a face normal that separates the boxes; -1 if none does. `x` is the box of the tree whose
// normals these are, and `y` the box of the other one.
ECODS_ALWAYS_INLINE int separating_face(const DoubleAxes& set, const RootBox& x, const RootBox& y,
                                        double sign) noexcept {
    const Double4 x_center = set.is_unit ? x.center : set.own * x.center;
    const Double4 x_half = set.is_unit ? x.half : absolute(set.own) * x.half;
    const Double4 distance = absolute((x_center - set.other * y.center) - sign * set.offset);
    const Double4 reach = (x_half + absolute(set.other) * y.half) + set.margin;
    for (int row = 0; row < 3; ++row) {
        if (distance[row] > reach[row]) return row;
    }
    return -1;
}

// Provides the tests that find_axis() calls, with one set computed after the other, for any poses.
struct SingleBoxes {
    const Edges edges_a, edges_b;
    const RootBox root_a, root_b;
    const Double4 d;
    DoubleAxes first, second;
    bool has_second = false;

    ECODS_ALWAYS_INLINE SingleBoxes(const PosedTree& a, const PosedTree& b, const Vec3& difference) noexcept
        : edges_a(a.tree.frame, a.R),
          edges_b(b.tree.frame, b.R),
          root_a(a.tree),
          root_b(b.tree),
          d(load3(difference.data())) {}

    ECODS_ALWAYS_INLINE int face_of_a() noexcept {
        first = DoubleAxes(FaceNormals(edges_a, edges_b), edges_a, edges_b, d, Own::a);
        return separating_face(first, root_a, root_b, 1);
    }
    ECODS_ALWAYS_INLINE int face_of_b() noexcept {
        if (has_second) return -1;
        second = DoubleAxes(FaceNormals(edges_b, edges_a), edges_a, edges_b, d, Own::b);
        has_second = true;
        return separating_face(second, root_b, root_a, -1);
    }
    ECODS_ALWAYS_INLINE int edges() const noexcept {
        return first.is_unit ? separating_edges(first.other, first.offset, first.margin, root_a, root_b) : -1;
    }
    ECODS_ALWAYS_INLINE void set(std::array<AxisSet, 2>& sets) const noexcept {
        set_floats(sets[0], first);
        set_floats(sets[1], second);
        sets[0].flat_axis = first.is_unit ? find_flat_axis(root_a.half, absolute(first.other) * root_b.half) : -1;
    }
};

[[gnu::noinline]] inline int bind_axis_sets(std::array<AxisSet, 2>& sets, const PosedTree& a, const PosedTree& b,
                                            const Vec3& difference, int preferred) noexcept {
    SingleBoxes boxes(a, b, difference);
    return find_axis(boxes, sets, preferred);
}
