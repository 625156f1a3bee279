// Two posed trees on the face normals of both at once, in registers of eight doubles: what posed_axes.hpp computes for
// one set of axes after the other, lane by lane with the same operations in the same order, so that the bits are the
// same. The first four lanes are those of the set of a's normals, the last four of b's.
//
// For poses that turn and no more, and numbers within their limits; others go through one set after the other.
#pragma once

#include "bvh/axes/posed_axes.hpp"
#include "simd/double8.hpp"

#if ECODS_CAN_DISPATCH

namespace ecods::axes {

using ecods::absolute;

ECODS_WIDE_INLINE Double8 both(double a, double b) noexcept {
    return join(broadcast<Double4>(a), broadcast<Double4>(b));
}
ECODS_WIDE_INLINE Double8 swapped(Double8 v) noexcept {
    return halves<1, 0>(v);
}
ECODS_WIDE_INLINE Double8 times(double x, Double8 v) noexcept {
    return eight(x) * v;
}
ECODS_WIDE_INLINE Double8 of_both(Double8 v) noexcept {  // their sum, in each half
    return v + swapped(v);
}

ECODS_WIDE_INLINE Double8 sum(Double8 v) noexcept {
    return (each<0>(v) + each<1>(v)) + each<2>(v);
}

// A matrix in each half.
struct BothMatrices {
    Double8 column[3];
};
ECODS_WIDE_INLINE Double8 operator*(const BothMatrices& m, Double8 v) noexcept {
    return (m.column[0] * each<0>(v) + m.column[1] * each<1>(v)) + m.column[2] * each<2>(v);
}
ECODS_WIDE_INLINE BothMatrices operator*(const BothMatrices& a, const BothMatrices& b) noexcept {
    return {{a * b.column[0], a * b.column[1], a * b.column[2]}};
}
ECODS_WIDE_INLINE BothMatrices absolute(const BothMatrices& m) noexcept {
    return {{absolute(m.column[0]), absolute(m.column[1]), absolute(m.column[2])}};
}
ECODS_WIDE_INLINE BothMatrices swapped(const BothMatrices& m) noexcept {
    return {{swapped(m.column[0]), swapped(m.column[1]), swapped(m.column[2])}};
}
ECODS_WIDE_INLINE BothMatrices distance_from_identity(const BothMatrices& m) noexcept {
    const Double4 x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0};
    return {
        {absolute(m.column[0] - join(x, x)), absolute(m.column[1] - join(y, y)), absolute(m.column[2] - join(z, z))}};
}
ECODS_WIDE_INLINE Double8 row_sums(const BothMatrices& m) noexcept {
    return (m.column[0] + m.column[1]) + m.column[2];
}
ECODS_WIDE_INLINE BothMatrices transpose(const BothMatrices& m) noexcept {
    const Double8 low = even_lanes(m.column[0], m.column[1]);
    const Double8 high = odd_lanes(m.column[0], m.column[1]);
    const auto z = m.column[2];
    return {{lanes_of<0, 1, 8, 11, 4, 5, 12, 15>(low, z), lanes_of<0, 1, 9, 11, 4, 5, 13, 15>(high, z),
             lanes_of<2, 3, 10, 11, 6, 7, 14, 15>(low, z)}};
}

ECODS_WIDE_INLINE BothMatrices load_both(const Mat3& a, const Mat3& b) noexcept {
    return {{load_three(a.data(), b.data()), load_three(a.data() + 3, b.data() + 3),
             load_three(a.data() + 6, b.data() + 6)}};
}

// The edges of both trees' boxes, as Edges has them.
struct BothEdges {
    BothMatrices edges;
    Double8 size, origin, origin_size, factor, per_scale;

    ECODS_WIDE_INLINE BothEdges(const PosedTree& a, const PosedTree& b) noexcept {
        const LocalFrame &frame_a = a.tree.frame, &frame_b = b.tree.frame;
        const BothMatrices R = load_both(a.R, b.R), R_size = absolute(R);
        const Double8 center = load_three(frame_a.center.data(), frame_b.center.data());
        edges = R * load_both(frame_a.map, frame_b.map);
        size = R_size * load_three(frame_a.map_size.data(), frame_b.map_size.data());
        origin = R * center;
        origin_size = R_size * absolute(center);
        factor = (eight(1) + sum(row_sums(R_size))) * both(frame_a.size_max, frame_b.size_max);
        per_scale = eight(1) / both(frame_a.scale, frame_b.scale);
    }
};

// Both sets in doubles, as DoubleAxes has them.
struct BothAxes {
    BothMatrices other;  // P of the tree that the normals are not of
    Double8 offset, margin, s, w, e;
    bool are_fit;  // otherwise nothing else means anything

    ECODS_WIDE_INLINE BothAxes(const BothEdges& both_edges, const Vec3& difference) noexcept {
        const BothMatrices& edges = both_edges.edges;
        const Double8 per_scale = both_edges.per_scale;
        const BothMatrices N = transpose(
            BothMatrices{{(edges.column[0] * per_scale) * per_scale, (edges.column[1] * per_scale) * per_scale,
                          (edges.column[2] * per_scale) * per_scale}});
        const BothMatrices own = N * edges;
        e = row_sums(distance_from_identity(own));
        other = N * swapped(edges);
        const BothMatrices N_size = absolute(N);
        const Double8 d = load_three(difference.data(), difference.data()), d_size = absolute(d);
        const Double8 origin = both_edges.origin;
        const Double8 origin_a = halves<0, 0>(origin);
        const Double8 origin_b = halves<1, 1>(origin);
        offset = N * ((origin_b - origin_a) + d);
        const Double8 world = (of_both(both_edges.size) + of_both(both_edges.origin_size)) + d_size;
        w = N_size * world;
        s = (row_sums(absolute(own)) + row_sums(absolute(other))) + absolute(offset);
        const Double8 factor = (of_both(both_edges.factor) + sum(d_size)) * sum(row_sums(N_size));
        // In this form NaN is not fit.
        are_fit = (is_at_most(sum(e), eight(unit_distance_max)) & is_less(sum(world), eight(world_max)) &
                   is_less(sum(s), eight(sum_max)) & is_less(sum(w), eight(sum_max)) &
                   is_less(factor, eight(factor_max))) == 0xff;
        margin = (times(32 * two_u, s + w) + times(2, e)) + eight(underflow);
    }
};

// The boxes of both trees as a whole, as RootBox has them.
struct BothRoots {
    Double8 center, half;

    ECODS_WIDE_INLINE BothRoots(const MeshBvh& a, const MeshBvh& b) noexcept
        : center(load_three(a.root_center.data(), b.root_center.data())),
          half(load_three(a.root_half.data(), b.root_half.data())) {}
};

// Which of the three normals of either separates the roots, as bits: 0 to 2 those of a, 4 to 6 those of b. Sets
// `other_half` to the reach of the box that the normals are not of.
ECODS_WIDE_INLINE std::uint32_t separating_faces(const BothAxes& axes, const BothRoots& roots,
                                                 Double8& other_half) noexcept {
    const Double8 signs = join(Double4{}, broadcast<Double4>(-0.0));
    other_half = absolute(axes.other) * swapped(roots.half);
    const Double8 distance = absolute((roots.center - axes.other * swapped(roots.center)) - flip(axes.offset, signs));
    const Double8 reach = (roots.half + other_half) + axes.margin;
    return is_greater(distance, reach) & 0x77u;
}

// Both halves as floats.
struct FloatHalves {
    Float4 low, high;

    ECODS_WIDE_INLINE explicit FloatHalves(Double8 v) noexcept { round_halves(v, low, high); }
};

// set_floats() of both.
ECODS_WIDE_INLINE void set_both_floats(std::array<AxisSet, 2>& sets, const BothAxes& exact) noexcept {
    const FloatHalves x(exact.other.column[0]), y(exact.other.column[1]), z(exact.other.column[2]), shift(exact.offset);
    set_unit_projection(sets[0].a, Float4{});
    set_projection(sets[0].b, {x.low, y.low, z.low, shift.low});
    set_projection(sets[1].a, {x.high, y.high, z.high, Float4{}});
    set_unit_projection(sets[1].b, shift.high);
    const Double8 in_float = times(float_u, exact.s);
    const Double8 in_double = times(16 * two_u, exact.w) + eight(underflow);
    const FloatHalves margin(times(1 + 0x1p-22, (times(16, in_float) + in_double) + times(2, exact.e)));
    const FloatHalves point_error(times(1 + 0x1p-22, (times(8, in_float) + in_double) + exact.e));
    store_anywhere(sets[0].b.margin.data(), margin.low);
    store_anywhere(sets[1].b.margin.data(), margin.high);
    store_anywhere(sets[0].point_error.data(), point_error.low);
    store_anywhere(sets[1].point_error.data(), point_error.high);
    const Double8 distance = exact.e + in_double;
    sets[0].is_bijective = largest(low_half(distance)) < 0x1p-4;
    sets[1].is_bijective = largest(high_half(distance)) < 0x1p-4;
}

}  // namespace ecods::axes

#endif
