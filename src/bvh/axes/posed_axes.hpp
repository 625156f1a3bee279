// Two posed trees on three axes, in doubles and in floats, with the bounds that separating_axes.hpp derives. Always
// inlined: compiled for the instruction set of the caller (simd/dispatch.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "base/arithmetic.hpp"
#include "bounds/double4.hpp"
#include "bvh/axes/separating_axes.hpp"
#include "simd/inline.hpp"

namespace ecods::axes {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double float_u = 0x1p-23;
inline constexpr double underflow = 0x1p-100;
inline constexpr double sum_max = 0x1p100;
inline constexpr double factor_max = 0x1p900;
inline constexpr double world_max = 0x1p1000;
inline constexpr double unit_distance_max = 0x1p-40;  // beyond, margins would suffer

// The edges and the center of a tree's boxes in the world, with the sums that enter the bound.
struct Edges {
    Matrix4 edges;        // R map
    Double4 size;         // |R| |map| 1
    Double4 origin;       // R center
    Double4 origin_size;  // |R| |center|
    double factor;        // above every number that a rounding error of these is multiplied by
    double scale;         // of the frame: a power of two, the length of the columns of map

    ECODS_ALWAYS_INLINE Edges(const LocalFrame& frame, const Mat3& pose_R) {
        const Matrix4 R = load3(pose_R);
        const Matrix4 R_size = absolute(R);
        const Double4 center = load3(frame.center.data());
        edges = R * load3(frame.map);
        size = R_size * load3(frame.map_size.data());
        origin = R * center;
        origin_size = R_size * absolute(center);
        factor = (1 + sum(row_sums(R_size))) * frame.size_max;
        scale = frame.scale;
    }
};

// The box of a whole tree, in its own coordinates.
struct RootBox {
    Double4 center, half;

    ECODS_ALWAYS_INLINE RootBox(Double4 its_center, Double4 its_half) : center(its_center), half(its_half) {}
    ECODS_ALWAYS_INLINE explicit RootBox(const MeshBvh& tree)
        : center{static_cast<double>(tree.root_center[0]), static_cast<double>(tree.root_center[1]),
                 static_cast<double>(tree.root_center[2]), 0},
          half{static_cast<double>(tree.root_half[0]), static_cast<double>(tree.root_half[1]),
               static_cast<double>(tree.root_half[2]), 0} {}
};

// The normals of the faces of a box with these edges, as rows, of such length that the box is about [-1, 1] on each;
// the axes of the world, so long that both boxes are about that, where the box is too flat for it. Any choice is sound.
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

// Which tree the axes are the face normals of.
enum class Own { a, b };

// How far a matrix is from the identity, by row.
ECODS_ALWAYS_INLINE Double4 distance_from_identity(const Matrix4& m) noexcept {
    return row_sums({{absolute(m.column[0] - Double4{1, 0, 0, 0}), absolute(m.column[1] - Double4{0, 1, 0, 0}),
                      absolute(m.column[2] - Double4{0, 0, 1, 0})}});
}

// The axes that axes_of() gives, but for rounding, and the own tree's P. Where a pose turns and no more, as nearly all
// do, edges are orthogonal and of one length, so that the normals lie along them: no determinant is asked for.
struct FaceNormals {
    Matrix4 N, own;

    ECODS_ALWAYS_INLINE FaceNormals(const Edges& edges, const Edges& other) noexcept {
        const double per_scale = 1 / edges.scale;
        const auto normal = [&](int k) { return (edges.edges.column[k] * per_scale) * per_scale; };
        N = transpose({{normal(0), normal(1), normal(2)}});
        own = N * edges.edges;
        if (sum(distance_from_identity(own)) <= unit_distance_max) [[likely]]
            return;
        N = axes_of(edges.edges, other.edges);
        own = N * edges.edges;
    }
};

// Three axes in doubles.
struct DoubleAxes {
    Matrix4 a, b;  // P
    Double4 offset, margin;
    Double4 s, w;  // the sums
    Double4 e;     // how far the own tree's P is from the identity, if it is taken for it
    bool is_unit;

    ECODS_ALWAYS_INLINE DoubleAxes(const FaceNormals& normals, const Edges& edges_a, const Edges& edges_b, Double4 d,
                                   Own own_tree)
        : DoubleAxes(normals.N, normals.own, edges_a, edges_b, d, absolute(d), Double4{}, own_tree) {}
    ECODS_ALWAYS_INLINE DoubleAxes(const Matrix4& N, const Edges& edges_a, const Edges& edges_b, Double4 d,
                                   Own own_tree)
        : DoubleAxes(N, edges_a, edges_b, d, absolute(d), Double4{}, own_tree) {}

    // For trees that move: `d_size` is at least |d| and the terms that d was made of by one rounding of their sum or
    // less, and `path` is how far they go on the axes, which is added to s as an offset is.
    ECODS_ALWAYS_INLINE DoubleAxes(const Matrix4& N, const Edges& edges_a, const Edges& edges_b, Double4 d,
                                   Double4 d_size, Double4 path, Own own_tree)
        : DoubleAxes(N, N * (own_tree == Own::a ? edges_a : edges_b).edges, edges_a, edges_b, d, d_size, path,
                     own_tree) {}
    ECODS_ALWAYS_INLINE DoubleAxes(const Matrix4& N, const Matrix4& own, const Edges& edges_a, const Edges& edges_b,
                                   Double4 d, Double4 d_size, Double4 path, Own own_tree) {
        const Matrix4 N_size = absolute(N);
        a = own_tree == Own::a ? own : N * edges_a.edges;
        b = own_tree == Own::b ? own : N * edges_b.edges;
        offset = N * ((edges_b.origin - edges_a.origin) + d);
        const Double4 world = ((edges_a.size + edges_b.size) + (edges_a.origin_size + edges_b.origin_size)) + d_size;
        w = N_size * world;
        s = ((row_sums(absolute(a)) + row_sums(absolute(b))) + absolute(offset)) + path;
        const double factor = ((edges_a.factor + edges_b.factor) + sum(d_size)) * sum(row_sums(N_size));
        e = distance_from_identity(own);
        is_unit = sum(e) <= unit_distance_max;
        if (!is_unit) e = Double4{};
        margin = (32 * two_u * (s + w) + 2 * e) + underflow;
        // In this form NaN is not bounded.
        const bool is_bounded = sum(world) < world_max && sum(s) < sum_max && sum(w) < sum_max && factor < factor_max;
        if (!is_bounded) margin += infinity;
    }

    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return margin[0] < infinity; }
};

using Float4 = Vec<float, 4>;

ECODS_ALWAYS_INLINE std::array<float, 4> to_floats(Double4 v) noexcept {
    const Vec<float, 4> f = convert<Vec<float, 4>>(v);
    std::array<float, 4> result;
    std::memcpy(&result, &f, sizeof f);
    return result;
}

// Four rows of four floats, as columns.
ECODS_ALWAYS_INLINE void store_transposed(const Float4 (&rows)[4], std::array<std::array<float, 4>, 3>& first_three) {
    const Float4 low_01 = shuffle<0, 4, 1, 5>(rows[0], rows[1]), high_01 = shuffle<2, 6, 3, 7>(rows[0], rows[1]);
    const Float4 low_23 = shuffle<0, 4, 1, 5>(rows[2], rows[3]), high_23 = shuffle<2, 6, 3, 7>(rows[2], rows[3]);
    store_anywhere(first_three[0].data(), shuffle<0, 1, 4, 5>(low_01, low_23));
    store_anywhere(first_three[1].data(), shuffle<2, 3, 6, 7>(low_01, low_23));
    store_anywhere(first_three[2].data(), shuffle<0, 1, 4, 5>(high_01, high_23));
}

// From the columns of P and the shift. Sizes are those of the numbers as converted: conversion is off by float_u of
// either.
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

// Of a tree on its own normals, whose P is taken for the identity, nothing but the shift is asked for.
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

// The last factor covers the rounding of the bounds to floats.
//
// The map to coordinates N x certainly is a bijection if N times the edges of the own tree's boxes is: as computed it
// is e from the identity, summed over a row, and that is off by less than 7 u' w. A matrix whose rows are less than one
// from the identity's is not singular.
ECODS_ALWAYS_INLINE void set_floats(AxisSet& set, const DoubleAxes& exact, Projection& own) noexcept {
    const bool a_is_unit = exact.is_unit && &own == &set.a, b_is_unit = exact.is_unit && &own == &set.b;
    set_projection(set.a, exact.a, Double4{}, a_is_unit);
    set_projection(set.b, exact.b, exact.offset, b_is_unit);
    const Double4 in_float = float_u * exact.s, in_double = 16 * two_u * exact.w + underflow;
    const double unbounded = exact.is_bounded() ? 0 : infinity;
    set.b.margin = to_floats((16 * in_float + in_double + 2 * exact.e) * (1 + 0x1p-22) + unbounded);
    set.point_error = to_floats((8 * in_float + in_double + exact.e) * (1 + 0x1p-22) + unbounded);
    set.is_bijective = exact.is_unit && largest(exact.e + in_double) < 0x1p-4;
}

}  // namespace ecods::axes
