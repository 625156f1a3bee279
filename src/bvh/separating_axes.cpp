#include "bvh/separating_axes.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "bounds/double4.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double double_u = 0x1p-52;  // one operation, any rounding mode
constexpr double float_u = 0x1p-23;
constexpr double underflow = 0x1p-100;
constexpr double sum_max = 0x1p100;
constexpr double factor_max = 0x1p900;
constexpr double world_max = 0x1p1000;
constexpr double unit_distance_max = 0x1p-40;  // beyond, margins would suffer

struct RootBox {
    Double4 center, half;

    ECODS_ALWAYS_INLINE explicit RootBox(const MeshBvh& tree)
        : center{static_cast<double>(tree.root_center[0]), static_cast<double>(tree.root_center[1]),
                 static_cast<double>(tree.root_center[2]), 0},
          half{static_cast<double>(tree.root_half[0]), static_cast<double>(tree.root_half[1]),
               static_cast<double>(tree.root_half[2]), 0} {}
};

// The edges and the center of a tree's boxes in the world, with the sums that enter the bound.
struct Edges {
    Matrix4 edges;        // R map
    Double4 size;         // |R| |map| 1
    Double4 origin;       // R center
    Double4 origin_size;  // |R| |center|
    double factor;        // above every number that a rounding error of these is multiplied by

    ECODS_ALWAYS_INLINE Edges(const LocalFrame& frame, const Mat3& pose_R) {
        const Matrix4 R = load3(pose_R);
        const Matrix4 R_size = absolute(R);
        const Double4 center = load3(frame.center.data());
        edges = R * load3(frame.map);
        size = R_size * load3(frame.map_size.data());
        origin = R * center;
        origin_size = R_size * absolute(center);
        factor = (1 + sum(row_sums(R_size))) * frame.size_max;
    }
};

// The normals of the faces as rows, of such length that the box is about [-1, 1] on each; the axes of the world where
// the box is too flat for that. Any choice is sound.
ECODS_ALWAYS_INLINE Matrix4 axes_of(const Edges& own, const Edges& other) noexcept {
    const Double4 x = own.edges.column[0], y = own.edges.column[1], z = own.edges.column[2];
    const Double4 yz = cross(y, z);
    const double det = dot(x, yz);
    if (det * det > 0x1p-40 * (dot(x, x) * dot(y, y) * dot(z, z))) {
        const double factor = 1 / det;
        return transpose({{yz * factor, cross(z, x) * factor, cross(x, y) * factor}});
    }
    const double size = std::max(largest(absolute(own.edges)), largest(absolute(other.edges)));
    const double factor = size > 0 ? 1 / size : 1;
    return {{Double4{factor, 0, 0, 0}, Double4{0, factor, 0, 0}, Double4{0, 0, factor, 0}}};
}

// Which tree the axes are the face normals of.
enum class Own { a, b };

// Three axes in doubles.
struct DoubleAxes {
    Matrix4 a, b;  // P
    Double4 offset, margin;
    Double4 s, w;  // the sums
    Double4 e;     // how far the own tree's P is from the identity, if it is taken for it
    bool is_unit;

    ECODS_ALWAYS_INLINE DoubleAxes(const Matrix4& N, const Edges& edges_a, const Edges& edges_b, Double4 d,
                                   Own own_tree) {
        const Matrix4 N_size = absolute(N);
        const Double4 d_size = absolute(d);
        a = N * edges_a.edges;
        b = N * edges_b.edges;
        offset = N * ((edges_b.origin - edges_a.origin) + d);
        const Double4 world = ((edges_a.size + edges_b.size) + (edges_a.origin_size + edges_b.origin_size)) + d_size;
        w = N_size * world;
        s = (row_sums(absolute(a)) + row_sums(absolute(b))) + absolute(offset);
        const double factor = ((edges_a.factor + edges_b.factor) + sum(d_size)) * sum(row_sums(N_size));
        const Matrix4& own = own_tree == Own::a ? a : b;
        e = row_sums({{absolute(own.column[0] - Double4{1, 0, 0, 0}), absolute(own.column[1] - Double4{0, 1, 0, 0}),
                       absolute(own.column[2] - Double4{0, 0, 1, 0})}});
        is_unit = sum(e) <= unit_distance_max;
        if (!is_unit) e = Double4{};
        margin = (32 * double_u * (s + w) + 2 * e) + underflow;
        // In this form NaN is not bounded.
        const bool is_bounded = sum(world) < world_max && sum(s) < sum_max && sum(w) < sum_max && factor < factor_max;
        if (!is_bounded) margin += infinity;
    }

    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return margin[0] < infinity; }
};

// Returns which of the three face normals separates the boxes, or -1. `x` is the box of the tree that the normals
// belong to; `p` maps the coordinates of the other box `y` to them.
ECODS_ALWAYS_INLINE int separating_face(const DoubleAxes& set, const RootBox& x, const Matrix4& own, const RootBox& y,
                                        const Matrix4& p, double sign) noexcept {
    const Double4 x_center = set.is_unit ? x.center : own * x.center;
    const Double4 x_half = set.is_unit ? x.half : absolute(own) * x.half;
    const Double4 distance = absolute((x_center - p * y.center) - sign * set.offset);
    const Double4 reach = (x_half + absolute(p) * y.half) + set.margin;
    for (int row = 0; row < 3; ++row) {
        if (distance[row] > reach[row]) return row;
    }
    return -1;
}

// Returns which of the nine cross products of edges separates the boxes, or -1. Edge i of a is tested with the three of
// b at once. Edge i of a is the axis i, so a product has two coordinates, k = i + 1 and l = i + 2.
ECODS_ALWAYS_INLINE int separating_edges(const DoubleAxes& set, const RootBox& x, const RootBox& y) noexcept {
    if (!set.is_unit) return -1;
    const Matrix4 rows = transpose(set.b);
    const Double4 middle = (set.b * y.center + set.offset) - x.center;
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3, l = (i + 2) % 3;
        const Double4 nk = -rows.column[l], nl = rows.column[k];
        Double4 distance = nk * middle[k] + nl * middle[l];
        Double4 reach =
            (absolute(nk) * (x.half[k] + set.margin[k]) + absolute(nl) * (x.half[l] + set.margin[l])) + 0x1p-800;
        for (int j = 0; j < 3; ++j) reach += absolute(nk * set.b.column[j][k] + nl * set.b.column[j][l]) * y.half[j];
        distance = absolute(distance);
        for (int j = 0; j < 3; ++j) {
            if (distance[j] > reach[j]) return 3 * i + j;
        }
    }
    return -1;
}

ECODS_ALWAYS_INLINE std::array<float, 4> to_floats(Double4 v) noexcept {
    const Vec<float, 4> f = convert<Vec<float, 4>>(v);
    std::array<float, 4> result;
    std::memcpy(&result, &f, sizeof f);
    return result;
}

ECODS_ALWAYS_INLINE void set_projection(Projection& projection, const Matrix4& P, Double4 shift) noexcept {
    const Matrix4 size = absolute(P);
    const Matrix4 rows = transpose(P);
    for (std::size_t j = 0; j < 3; ++j) {
        projection.p[j] = to_floats(P.column[j]);
        projection.size[j] = to_floats(size.column[j]);
        Double4 row = rows.column[j];
        row[3] = shift[static_cast<int>(j)];
        projection.row[j] = to_floats(row);
    }
    projection.shift = to_floats(shift);
    projection.margin = {};
    projection.is_unit = false;
}

// The last factor covers the rounding of the bounds to floats.
ECODS_ALWAYS_INLINE void set_floats(AxisSet& set, const DoubleAxes& exact, Projection& own) noexcept {
    set_projection(set.a, exact.a, Double4{});
    set_projection(set.b, exact.b, exact.offset);
    own.is_unit = exact.is_unit;
    const Double4 in_float = float_u * exact.s, in_double = 16 * double_u * exact.w + underflow;
    const double unbounded = exact.is_bounded() ? 0 : infinity;
    set.b.margin = to_floats((16 * in_float + in_double + 2 * exact.e) * (1 + 0x1p-22) + unbounded);
    set.point_error = to_floats((8 * in_float + in_double + exact.e) * (1 + 0x1p-22) + unbounded);
}

// Returns the number of an axis that separates the roots, or sets the sets and returns -1. Tests the normals of b
// before those of a, or the edges before the normals of b, if the axis `preferred` is one of them.
ECODS_ALWAYS_INLINE int bind_sets(std::array<AxisSet, 2>& sets, const PosedTree& a, const PosedTree& b,
                                  const Vec3& difference, int preferred) noexcept {
    const Edges edges_a(a.tree.frame, a.R), edges_b(b.tree.frame, b.R);
    const RootBox root_a(a.tree), root_b(b.tree);
    const Double4 d = load3(difference.data());
    if (preferred >= 3 && preferred < 6) {
        const DoubleAxes second(axes_of(edges_b, edges_a), edges_a, edges_b, d, Own::b);
        const int face = separating_face(second, root_b, second.b, root_a, second.a, -1);
        if (face >= 0) return 3 + face;
    }
    const DoubleAxes first(axes_of(edges_a, edges_b), edges_a, edges_b, d, Own::a);
    const int face_a = separating_face(first, root_a, first.a, root_b, first.b, 1);
    if (face_a >= 0) return face_a;
    if (preferred >= 6) {
        const int edges = separating_edges(first, root_a, root_b);
        if (edges >= 0) return 6 + edges;
    }
    const DoubleAxes second(axes_of(edges_b, edges_a), edges_a, edges_b, d, Own::b);
    const int face_b = separating_face(second, root_b, second.b, root_a, second.a, -1);
    if (face_b >= 0) return 3 + face_b;
    if (preferred < 6) {
        const int edges = separating_edges(first, root_a, root_b);
        if (edges >= 0) return 6 + edges;
    }
    set_floats(sets[0], first, sets[0].a);
    set_floats(sets[1], second, sets[1].b);
    return -1;
}

}  // namespace

int SeparatingAxes::bind(const PosedTree& a, const PosedTree& b, const Vec3& d, int first) {
    if (a.tree.frame.is_bounded && b.tree.frame.is_bounded) return dispatch<bind_sets>(sets_, a, b, d, first);
    // A tree without bounds is never separated.
    constexpr float unbounded = std::numeric_limits<float>::infinity();
    for (AxisSet& set : sets_) {
        set = {};
        set.b.margin.fill(unbounded);
        set.point_error.fill(unbounded);
    }
    return -1;
}

}  // namespace ecods
