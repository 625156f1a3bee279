#include "bvh/axes/separating_axes.hpp"

#include <bit>

#include "bvh/axes/both_axes.hpp"
#include "bvh/axes/posed_axes.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

using namespace axes;

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

// Returns the axis on which both boxes have less than 2^-20 of their greatest extent, or -1: there triangles are parted
// by edges, not by planes. Any answer is sound.
ECODS_ALWAYS_INLINE int find_flat_axis(Double4 x_half, Double4 y_half) noexcept {
    const double x_thin = 0x1p-20 * largest(x_half), y_thin = 0x1p-20 * largest(y_half);
    for (int axis = 0; axis < 3; ++axis) {
        if (x_half[axis] <= x_thin && y_half[axis] <= y_thin) return axis;
    }
    return -1;
}

// Returns the number of an axis that separates the roots, or sets the sets and returns -1. Tests the normals of b
// before those of a, or the edges before the normals of b, if the axis `preferred` is one of them.
ECODS_ALWAYS_INLINE int bind_axis_sets(std::array<AxisSet, 2>& sets, const PosedTree& a, const PosedTree& b,
                                       const Vec3& difference, int preferred) noexcept {
    const Edges edges_a(a.tree.frame, a.R), edges_b(b.tree.frame, b.R);
    const RootBox root_a(a.tree), root_b(b.tree);
    const Double4 d = load3(difference.data());
    if (preferred >= 3 && preferred < 6) {
        const DoubleAxes second(FaceNormals(edges_b, edges_a), edges_a, edges_b, d, Own::b);
        const int face = separating_face(second, root_b, second.b, root_a, second.a, -1);
        if (face >= 0) return 3 + face;
    }
    const DoubleAxes first(FaceNormals(edges_a, edges_b), edges_a, edges_b, d, Own::a);
    const int face_a = separating_face(first, root_a, first.a, root_b, first.b, 1);
    if (face_a >= 0) return face_a;
    const auto separating_edge = [&] {
        return first.is_unit ? separating_edges(first.b, first.offset, first.margin, root_a, root_b) : -1;
    };
    if (preferred >= 6) {
        const int edges = separating_edge();
        if (edges >= 0) return 6 + edges;
    }
    const DoubleAxes second(FaceNormals(edges_b, edges_a), edges_a, edges_b, d, Own::b);
    const int face_b = separating_face(second, root_b, second.b, root_a, second.a, -1);
    if (face_b >= 0) return 3 + face_b;
    if (preferred < 6) {
        const int edges = separating_edge();
        if (edges >= 0) return 6 + edges;
    }
    set_floats(sets[0], first, sets[0].a);
    set_floats(sets[1], second, sets[1].b);
    sets[0].flat_axis = first.is_unit ? find_flat_axis(root_a.half, absolute(first.b) * root_b.half) : -1;
    return -1;
}

#if ECODS_CAN_DISPATCH
// The same with both sets at once, for poses that turn.
ECODS_WIDE int bind_both_axis_sets(std::array<AxisSet, 2>& sets, const PosedTree& a, const PosedTree& b,
                                   const Vec3& difference, int preferred) noexcept {
    const BothAxes both(BothEdges(a, b), difference);
    if (!both.are_fit) return on_avx512<bind_axis_sets>(sets, a, b, difference, preferred);
    const BothRoots roots(a.tree, b.tree);
    Double8 other_half;
    const std::uint32_t faces = separating_faces(both, roots, other_half);
    const std::uint32_t faces_a = faces & 7, faces_b = faces >> 4;
    const Matrix4 P = {
        {low_half(both.other.column[0]), low_half(both.other.column[1]), low_half(both.other.column[2])}};
    const Double4 offset = low_half(both.offset), margin = low_half(both.margin);
    const RootBox root_a(low_half(roots.center), low_half(roots.half)),
        root_b(high_half(roots.center), high_half(roots.half));
    const bool is_b_first = preferred >= 3 && preferred < 6;
    if (faces_a != 0 && !(is_b_first && faces_b != 0)) return std::countr_zero(faces_a);
    if (preferred >= 6) {
        const int edges = separating_edges(P, offset, margin, root_a, root_b);
        if (edges >= 0) return 6 + edges;
    }
    if (faces_b != 0) return 3 + std::countr_zero(faces_b);
    if (preferred < 6) {
        const int edges = separating_edges(P, offset, margin, root_a, root_b);
        if (edges >= 0) return 6 + edges;
    }
    set_both_floats(sets, both);
    sets[0].flat_axis = find_flat_axis(root_a.half, low_half(other_half));
    return -1;
}
#endif

}  // namespace

int SeparatingAxes::bind(const PosedTree& a, const PosedTree& b, const Vec3& d, int first) {
    if (a.tree.frame.is_bounded && b.tree.frame.is_bounded) {
#if ECODS_CAN_DISPATCH
        if (read_instruction_set() == InstructionSet::avx512) return bind_both_axis_sets(sets_, a, b, d, first);
#endif
        return dispatch<bind_axis_sets>(sets_, a, b, d, first);
    }
    // A tree without bounds is never separated.
    for (AxisSet& set : sets_) {
        set = {};
        set.set_unbounded();
    }
    return -1;
}

}  // namespace ecods
