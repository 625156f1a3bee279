// bvh/axes/posed_axes.hpp includes this source once for each instruction set.

using namespace axes;

// NumberOf<V> holds one number for each body in V: it is double for one body, Double8 for two.
template <class V>
using NumberOf = decltype(sum(V{}));

ECODS_ALWAYS_INLINE bool are_at_most(double number, double limit) noexcept {
    return number <= limit;
}
ECODS_ALWAYS_INLINE bool are_below(double number, double limit) noexcept {
    return number < limit;
}

// Holds the edges and the center of a tree's local frame in the world, and the sums that the bound needs.
template <class V>
struct EdgesOf {
    Matrix<V> edges;     // R map
    V size;              // |R| |map| 1
    V origin;            // R center
    V origin_size;       // |R| |center|
    NumberOf<V> factor;  // upper bound of all numbers by which a rounding error of these is multiplied
    NumberOf<V> scale;   // the frame's scale: a power of two, the length of map's columns

    ECODS_ALWAYS_INLINE EdgesOf() noexcept {}
    ECODS_ALWAYS_INLINE EdgesOf(const Matrix<V>& R, const Matrix<V>& map, V map_size, V center, NumberOf<V> size_max,
                                NumberOf<V> scale_of_map) noexcept {
        const Matrix<V> R_size = absolute(R);
        edges = R * map;
        size = R_size * map_size;
        origin = R * center;
        origin_size = R_size * absolute(center);
        factor = (1 + sum(row_sums(R_size))) * size_max;
        scale = scale_of_map;
    }
};

struct Edges : EdgesOf<Double4> {
    // Makes the edges of a point that is the origin of its body.
    ECODS_ALWAYS_INLINE Edges() noexcept {
        edges = Matrix4{};
        size = origin = origin_size = Double4{};
        factor = scale = 1;
    }
    ECODS_ALWAYS_INLINE Edges(const LocalFrame& frame, const Mat3& R) noexcept
        : EdgesOf(load3(R), load3(frame.map), load3(frame.map_size.data()), load3(frame.center.data()), frame.size_max,
                  frame.scale) {}
};

// Holds the box of a tree's root, in the tree's own coordinates.
struct RootBox {
    Double4 center, half;

    ECODS_ALWAYS_INLINE explicit RootBox(const MeshBvh& tree) noexcept
        : center{static_cast<double>(tree.root_center[0]), static_cast<double>(tree.root_center[1]),
                 static_cast<double>(tree.root_center[2]), 0},
          half{static_cast<double>(tree.root_half[0]), static_cast<double>(tree.root_half[1]),
               static_cast<double>(tree.root_half[2]), 0} {}
};

// Returns the face normals of a box with the edges `own`, as rows, scaled such that the box is about [-1, 1] on each.
// If the box is too flat for that, returns the axes of the world, scaled such that both boxes are about [-1, 1]. Any
// axes would be sound; these separate well.
ECODS_ALWAYS_INLINE Matrix4 axes_of(const Matrix4& own, const Matrix4& other) noexcept {
    const Double4 x = own.column[0], y = own.column[1], z = own.column[2];
    const Double4 yz = cross(y, z);
    const double det = dot(x, yz);
    if (det * det > 0x1p-40 * (dot(x, x) * dot(y, y) * dot(z, z))) {
        const double factor = 1 / det;
        return transpose({{yz * factor, cross(z, x) * factor, cross(x, y) * factor}});
    }
    const double size = std::max(largest(absolute(own)), largest(absolute(other)));
    const double factor = size > 0 ? 1 / size : 1;
    return {{Double4{factor, 0, 0, 0}, Double4{0, factor, 0, 0}, Double4{0, 0, factor, 0}}};
}

// Returns the sum of |m - I| over each row.
ECODS_ALWAYS_INLINE Double4 distance_from_identity(const Matrix4& m) noexcept {
    return row_sums(Matrix4{{absolute(m.column[0] - Double4{1, 0, 0, 0}), absolute(m.column[1] - Double4{0, 1, 0, 0}),
                             absolute(m.column[2] - Double4{0, 0, 1, 0})}});
}

// Returns the result of axes_of(), up to rounding, for a pose that is a rotation, as nearly all poses are. Then the
// edges are orthogonal and of one length, so the normals are parallel to the edges, and no determinant is needed.
template <class V>
ECODS_ALWAYS_INLINE Matrix<V> normals_along(const EdgesOf<V>& edges) noexcept {
    const NumberOf<V> per_scale = 1 / edges.scale;
    const auto normal = [&](int k) -> V { return (edges.edges.column[k] * per_scale) * per_scale; };
    return transpose(Matrix<V>{{normal(0), normal(1), normal(2)}});
}

// Holds the face normals N of a tree's box for any pose R, t, and own = P = N R map, where `map` is that of the tree's
// frame.
struct FaceNormals {
    Matrix4 N, own;

    ECODS_ALWAYS_INLINE FaceNormals(const Edges& edges, const Edges& other) noexcept {
        N = normals_along<Double4>(edges);
        own = N * edges.edges;
        if (sum(distance_from_identity(own)) <= unit_distance_max) [[likely]]
            return;
        N = axes_of(edges.edges, other.edges);
        own = N * edges.edges;
    }
};

// Holds two trees a and b on three axes in doubles. If V is Double8, the low half is on the normals of a, and the high
// half is on the normals of b.
template <class V>
struct AxesOf {
    Matrix<V> own, other;  // matrix P (separating_axes.hpp) of the tree that gives the axes; of the other
    V offset, margin;
    V s, w;  // the sums s and w of separating_axes.hpp
    V e;     // row sums of |P - I| for the own P if it is taken for the identity; otherwise 0
    bool is_unit;
    bool is_bounded;

    ECODS_ALWAYS_INLINE AxesOf() noexcept {}
    // Sets the axes of trees at rest. `between` is the vector from the origin of a to the origin of b. `d_size` must be
    // at least |d|, and at least the sum of the magnitudes of the terms of d, up to one rounding.
    ECODS_ALWAYS_INLINE AxesOf(const Matrix<V>& N, const Matrix<V>& own_P, const EdgesOf<V>& own_edges,
                               const EdgesOf<V>& other_edges, V between, V d_size) noexcept {
        set_sums(N, own_P, own_edges, other_edges, between, d_size);
        set_margin();
    }

    // Sets the axes of two trees, one of which moves. `path` is its motion on the axes; it is added to s, like an
    // offset.
    ECODS_ALWAYS_INLINE AxesOf(const Matrix<V>& N, const EdgesOf<V>& own_edges, const EdgesOf<V>& other_edges,
                               V between, V d_size, V path) noexcept {
        set_sums(N, N * own_edges.edges, own_edges, other_edges, between, d_size);
        s += path;
        is_bounded = is_bounded && are_below(sum(s), sum_max);
        set_margin();
    }

  private:
    ECODS_ALWAYS_INLINE void set_sums(const Matrix<V>& N, const Matrix<V>& own_P, const EdgesOf<V>& own_edges,
                                      const EdgesOf<V>& other_edges, V between, V d_size) noexcept {
        const Matrix<V> N_size = absolute(N);
        own = own_P;
        other = N * other_edges.edges;
        offset = N * between;
        const V world =
            ((own_edges.size + other_edges.size) + (own_edges.origin_size + other_edges.origin_size)) + d_size;
        w = N_size * world;
        s = (row_sums(absolute(own)) + row_sums(absolute(other))) + absolute(offset);
        const NumberOf<V> factor = ((own_edges.factor + other_edges.factor) + sum(d_size)) * sum(row_sums(N_size));
        e = distance_from_identity(own);
        is_unit = are_at_most(sum(e), unit_distance_max);
        // If a number is NaN, its comparison is false, and the axes count as unbounded.
        is_bounded = are_below(sum(world), world_max) && are_below(sum(s), sum_max) && are_below(sum(w), sum_max) &&
                     are_below(factor, factor_max);
    }
    ECODS_ALWAYS_INLINE void set_margin() noexcept {
        if (!is_unit) e = V{};
        margin = (32 * two_u * (s + w) + 2 * e) + underflow;
        if (!is_bounded) margin += infinity;
    }
};

// Holds both trees on the face normals of one tree (`own_tree`), or on any axes N.
struct DoubleAxes : AxesOf<Double4> {
    Own own_tree = Own::a;

    ECODS_ALWAYS_INLINE DoubleAxes() noexcept {}
    ECODS_ALWAYS_INLINE DoubleAxes(const FaceNormals& normals, const Edges& a, const Edges& b, Double4 d,
                                   Own of) noexcept
        : AxesOf(normals.N, normals.own, of == Own::a ? a : b, of == Own::a ? b : a, (b.origin - a.origin) + d,
                 absolute(d)),
          own_tree(of) {}
    ECODS_ALWAYS_INLINE DoubleAxes(const Matrix4& N, const Edges& a, const Edges& b, Double4 d, Own of) noexcept
        : DoubleAxes(N, a, b, d, absolute(d), Double4{}, of) {}
    ECODS_ALWAYS_INLINE DoubleAxes(const Matrix4& N, const Edges& a, const Edges& b, Double4 d, Double4 d_size,
                                   Double4 path, Own of) noexcept
        : AxesOf(N, of == Own::a ? a : b, of == Own::a ? b : a, (b.origin - a.origin) + d, d_size, path),
          own_tree(of) {}

    ECODS_ALWAYS_INLINE const Matrix4& a() const noexcept { return own_tree == Own::a ? own : other; }
    ECODS_ALWAYS_INLINE const Matrix4& b() const noexcept { return own_tree == Own::a ? other : own; }
};

using Float4 = Vec<float, 4>;

ECODS_ALWAYS_INLINE std::array<float, 4> to_floats(Double4 v) noexcept {
    const Vec<float, 4> f = convert<Vec<float, 4>>(v);
    std::array<float, 4> result;
    std::memcpy(&result, &f, sizeof f);
    return result;
}

// Stores the first three columns of the matrix whose rows are `rows`.
ECODS_ALWAYS_INLINE void store_transposed(const Float4 (&rows)[4], std::array<std::array<float, 4>, 3>& first_three) {
    const Float4 low_01 = shuffle<0, 4, 1, 5>(rows[0], rows[1]), high_01 = shuffle<2, 6, 3, 7>(rows[0], rows[1]);
    const Float4 low_23 = shuffle<0, 4, 1, 5>(rows[2], rows[3]), high_23 = shuffle<2, 6, 3, 7>(rows[2], rows[3]);
    store_anywhere(first_three[0].data(), shuffle<0, 1, 4, 5>(low_01, low_23));
    store_anywhere(first_three[1].data(), shuffle<2, 3, 6, 7>(low_01, low_23));
    store_anywhere(first_three[2].data(), shuffle<0, 1, 4, 5>(high_01, high_23));
}

// Sets the projection from the columns of the matrix P (separating_axes.hpp) and, as the fourth column, the shift.
// `size` has the magnitudes of the converted numbers, which differ from the exact ones by a factor of float_u.
ECODS_ALWAYS_INLINE void set_projection(Projection& projection, const Float4 (&columns)[4]) noexcept {
    for (std::size_t j = 0; j < 3; ++j) {
        store_anywhere(projection.p[j].data(), columns[j]);
        store_anywhere(projection.size[j].data(), absolute(columns[j]));
    }
    store_transposed(columns, projection.row);
    store_anywhere(projection.shift.data(), columns[3]);
    projection.margin = {};
    projection.is_unit = false;
}

// Sets the projection of a tree on its own normals. The matrix P of the tree (separating_axes.hpp) is taken for the
// identity, so only the shift is set.
ECODS_ALWAYS_INLINE void set_unit_projection(Projection& projection, Float4 shift) noexcept {
    store_anywhere(projection.shift.data(), shift);
    for (std::size_t j = 0; j < 3; ++j) projection.row[j][3] = projection.shift[j];
    projection.margin = {};
    projection.is_unit = true;
}
ECODS_ALWAYS_INLINE void set_projection(Projection& projection, const Matrix4& P, Double4 shift,
                                        bool is_unit) noexcept {
    const Float4 float_shift = convert<Float4>(shift);
    if (is_unit) return set_unit_projection(projection, float_shift);
    set_projection(projection, {convert<Float4>(P.column[0]), convert<Float4>(P.column[1]),
                                convert<Float4>(P.column[2]), float_shift});
}

// Sets `set` to both trees' maps and margins, rounded to floats. The factor 1 + 2^-22 covers the rounding of the
// margins.
//
// is_bijective is set if the map to coordinates N x is certainly a bijection. The map is a bijection if N times the
// edges of the own tree's boxes is a regular matrix. As computed, the row sums of this product minus I are e, with an
// error of less than 7 u' w. A matrix is regular if its rows differ from the identity's by less than one.
// Claim: verify/proofs/posed_axes.py
// Claim: verify/proofs/float_axes.py
ECODS_ALWAYS_INLINE void set_floats(AxisSet& set, const DoubleAxes& exact) noexcept {
    const bool is_of_a = exact.own_tree == Own::a;
    set_projection(set.a, exact.a(), Double4{}, exact.is_unit && is_of_a);
    set_projection(set.b, exact.b(), exact.offset, exact.is_unit && !is_of_a);
    const Double4 in_float = float_u * exact.s, in_double = 16 * two_u * exact.w + underflow;
    const double unbounded = exact.is_bounded ? 0 : infinity;
    set.b.margin = to_floats((16 * in_float + in_double + 2 * exact.e) * (1 + 0x1p-22) + unbounded);
    set.point_error = to_floats((8 * in_float + in_double + exact.e) * (1 + 0x1p-22) + unbounded);
    set.is_bijective = exact.is_unit && largest(exact.e + in_double) < 0x1p-4;
}
