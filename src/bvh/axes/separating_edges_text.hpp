// bvh/axes/separating_axes.cpp includes this source once for each instruction set, AVX-512 included.

// Returns the number, 0 to 8, of a cross product of edges that separates the boxes x and y; -1 if none does. Edge i of
// a is tested with the three edges of b at once. Edge i of a is the axis i, so a cross product has only two coordinates
// that are not zero, k = i + 1 and l = i + 2 (modulo 3).
ECODS_ALWAYS_INLINE int separating_edges(const Matrix4& b, Double4 offset, Double4 margin, const RootBox& x,
                                         const RootBox& y) noexcept {
    const Matrix4 rows = transpose(b);
    const Double4 middle = (b * y.center + offset) - x.center;
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3, l = (i + 2) % 3;
        const Double4 nk = -rows.column[l], nl = rows.column[k];
        Double4 distance = nk * middle[k] + nl * middle[l];
        Double4 reach = (absolute(nk) * (x.half[k] + margin[k]) + absolute(nl) * (x.half[l] + margin[l])) + 0x1p-800;
        for (int j = 0; j < 3; ++j) reach += absolute(nk * b.column[j][k] + nl * b.column[j][l]) * y.half[j];
        distance = absolute(distance);
        for (int j = 0; j < 3; ++j) {
            if (distance[j] > reach[j]) return 3 * i + j;
        }
    }
    return -1;
}

// Returns the axis on which each box has at most 2^-20 of its greatest extent; -1 if there is none. Triangles of trees
// that are flat on this axis are separated by edges and not by planes. Any result is sound.
ECODS_ALWAYS_INLINE int find_flat_axis(Double4 x_half, Double4 y_half) noexcept {
    const double x_thin = 0x1p-20 * largest(x_half), y_thin = 0x1p-20 * largest(y_half);
    for (int axis = 0; axis < 3; ++axis) {
        if (x_half[axis] <= x_thin && y_half[axis] <= y_thin) return axis;
    }
    return -1;
}

// Returns the number of an axis that separates the roots; if none does, sets `sets` and returns -1. Tests the normals
// of a first, then the normals of b, then the edges. If `preferred` is a normal of b, these are tested first; if it is
// an edge, the edges are tested before the normals of b.
template <class Boxes>
ECODS_ALWAYS_INLINE int find_axis(Boxes& boxes, std::array<AxisSet, 2>& sets, int preferred) noexcept {
    int found = -1;
    if (preferred >= 3 && preferred < 6) {
        found = boxes.face_of_b();
        if (found >= 0) return 3 + found;
    }
    found = boxes.face_of_a();
    if (found >= 0) return found;
    if (preferred >= 6) {
        found = boxes.edges();
        if (found >= 0) return 6 + found;
    }
    found = boxes.face_of_b();
    if (found >= 0) return 3 + found;
    if (preferred < 6) {
        found = boxes.edges();
        if (found >= 0) return 6 + found;
    }
    boxes.set(sets);
    return -1;
}
