// The boxes of eight poses at once, in registers of eight doubles: four_boxes.hpp lane by lane, with the same
// operations in the same order, so that the boxes are the same bits.
#pragma once

#include <array>
#include <cstdint>

#include "bounds/four_boxes.hpp"
#include "simd/double8.hpp"

#if ECODS_CAN_DISPATCH

namespace ecods::support {

// Beside those of four.
using ecods::larger, ecods::negative, ecods::next_up_of_finite;

// Which axis is the longest of each, and the coordinate of three that is on it.
struct AxisOfEight {
    Mask8 is_y, is_z;

    ECODS_WIDE_INLINE Double8 of(Double8 a, Double8 b, Double8 c) const noexcept {
        return either(is_z, c, either(is_y, b, a));
    }
};

struct EightReaches {
    Double8 along, against;
};

// Where a corner of each cell is in the table.
struct EightPlacesInTable {
    alignas(32) std::array<std::int32_t, 8> at;

    ECODS_WIDE_INLINE explicit EightPlacesInTable(Int8 places) noexcept { store(places, at); }
};

// The values at a corner of each cell, or so much further on: both ends of its direction lie side by side in the table.
ECODS_WIDE_INLINE EightReaches table_corner(const Row& support, const EightPlacesInTable& places,
                                            int further = 0) noexcept {
    EightReaches reaches;
    load_pairs(support.data() + 2 * further, places.at, reaches.along, reaches.against);
    return reaches;
}

// A place in the grid: the cell, and how far it is in it.
struct EightPlaces {
    Int8 cell;
    Double8 rest;

    ECODS_WIDE_INLINE EightPlaces(Double8 coordinate, Double8 to_cells) noexcept {
        const Double8 at = coordinate * to_cells + eight(middle);
        const Double8 inside = larger(smaller(at, eight(cell_count)), eight(0));
        cell = smaller(truncated(inside), eight_ints(cell_count - 1));
        rest = inside - doubles_of(cell);
    }
};

// reaches() of one row of each of eight.
ECODS_WIDE_INLINE EightReaches eight_reaches(const Row& support, Double8 x, Double8 y, Double8 z) noexcept {
    const Double8 size_x = absolute(x), size_y = absolute(y), size_z = absolute(z);
    const Mask8 is_y = is_less(size_x, size_y);
    const Double8 size_xy = larger(size_y, size_x);
    const Mask8 is_z = is_less(size_xy, size_z);
    const Double8 m = larger(size_z, size_xy);
    const AxisOfEight axis{is_y, is_z};
    const Mask8 is_tiny = is_less(m, eight(tiny));
    const Double8 d = either(is_tiny, eight(1), axis.of(x, y, z));
    constexpr int face = SupportTableGrid::face_size;
    const Int8 start = either(is_z, eight_ints(2 * face), or_zero(is_y, face));

    const Double8 to_cells = eight(middle) / d;
    const EightPlaces i(axis.of(y, z, x), to_cells), j(axis.of(z, x, y), to_cells);

    // Each cell is cut along its diagonal.
    const Mask8 is_first_less = is_less(i.rest, j.rest);
    const Double8 low = smaller(i.rest, j.rest), high = larger(j.rest, i.rest);
    const Double8 first_share = eight(1) - high, across_share = high - low;
    static_assert(side_count == 9);
    const Int8 row = plus(times_power_of_two<3>(j.cell), j.cell);
    const Int8 first = plus(plus(start, row), i.cell);
    const Int8 across = plus(first, either(is_first_less, eight_ints(side_count), eight_ints(1)));
    const EightPlacesInTable first_places(first);
    const EightReaches a = table_corner(support, first_places), b = table_corner(support, EightPlacesInTable(across)),
                       c = table_corner(support, first_places, side_count + 1);
    const Double8 up = (first_share * a.along + across_share * b.along) + low * c.along;
    const Double8 down = (first_share * a.against + across_share * b.against) + low * c.against;
    const Mask8 is_negative = is_less(d, eight(0));
    const Double8 along = either(is_negative, down, up), against = either(is_negative, up, down);
    return {either(is_tiny, eight(4) * m, m * (along + eight(table_error))),
            either(is_tiny, eight(4) * m, m * (against + eight(table_error)))};
}

// Boxes from the ends of four of them, lane by lane.
ECODS_ALWAYS_INLINE void store_four(const Double4 (&ends)[6], Aabb* const* boxes) noexcept {
    static_assert(sizeof(Aabb) == 6 * sizeof(double), "the lower ends, then the upper ones");
    const Double4 xy_even = shuffle<0, 4, 2, 6>(ends[0], ends[1]), xy_odd = shuffle<1, 5, 3, 7>(ends[0], ends[1]);
    const Double4 zx_even = shuffle<0, 4, 2, 6>(ends[2], ends[3]), zx_odd = shuffle<1, 5, 3, 7>(ends[2], ends[3]);
    const Double4 yz_even = shuffle<0, 4, 2, 6>(ends[4], ends[5]), yz_odd = shuffle<1, 5, 3, 7>(ends[4], ends[5]);
    const Double4 first[4] = {shuffle<0, 1, 4, 5>(xy_even, zx_even), shuffle<0, 1, 4, 5>(xy_odd, zx_odd),
                              shuffle<2, 3, 6, 7>(xy_even, zx_even), shuffle<2, 3, 6, 7>(xy_odd, zx_odd)};
    const Double2 last[4] = {Double2{yz_even[0], yz_even[1]}, Double2{yz_odd[0], yz_odd[1]},
                             Double2{yz_even[2], yz_even[3]}, Double2{yz_odd[2], yz_odd[3]}};
    for (int i = 0; i < 4; ++i) {
        store_anywhere(boxes[i]->min.data(), first[i]);
        store_anywhere(boxes[i]->min.data() + 4, last[i]);
    }
}

// exact::point_error_bound() of each.
ECODS_WIDE_INLINE Double8 eight_point_error_bounds(Double8 sum_max, Double8 factor_max) noexcept {
    const Double8 lost = eight(0x1p-1000);
    const Double8 underflow = either(is_less(factor_max, eight(0x1p19)), lost, lost + lost * factor_max);
    return eight(4.25 * double_u) * sum_max + underflow;
}

ECODS_WIDE_INLINE Double8 times(const Double8* row, const Vec3& v) noexcept {
    return (row[0] * eight(v[0]) + row[1] * eight(v[1])) + row[2] * eight(v[2]);
}

// Returns whether no pose need be scaled for its box; otherwise the boxes are not set.
ECODS_WIDE inline bool eight_boxes_by_table(const TableView& table, const std::array<const Pose*, 8>& poses,
                                            const std::array<Aabb*, 8>& boxes) noexcept {
    const RowsOfFour low = load_four({poses[0], poses[1], poses[2], poses[3]});
    const RowsOfFour high = load_four({poses[4], poses[5], poses[6], poses[7]});
    Double8 R[3][3], t[3], size[3][3], sum_max = eight(0), size_max = eight(0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            R[row][column] = join(low.R[row][column], high.R[row][column]);
            size[row][column] = absolute(R[row][column]);
            size_max = larger(size_max, size[row][column]);
        }
        t[row] = join(low.t[row], high.t[row]);
        const Double8* const s = size[row];
        const Double8 sum =
            (s[0] * eight(table.v_max[0]) + s[1] * eight(table.v_max[1])) + s[2] * eight(table.v_max[2]);
        sum_max = larger(sum_max, sum + absolute(t[row]));
    }
    const LocalFrame& frame = table.frame;
    const Double8 factor_max = larger(size_max, eight(table.v_max_of_all));
    const Double8 delta = eight_point_error_bounds(sum_max, factor_max), least = eight(unscaled_min);
    const Mask8 is_low = is_less(sum_max, eight(sum_limit)) & is_less(size_max, eight(size_limit));
    if ((is_low & is_less(least + least * factor_max, delta)) != 0xff) return false;
    Double8 ends[6];
    for (int row = 0; row < 3; ++row) {
        const Double8* const r = R[row];
        const Double8 center = times(r, frame.center) + t[row];
        const Double8 x = absolute(times(r, frame.axes.col(0))), y = absolute(times(r, frame.axes.col(1))),
                      z = absolute(times(r, frame.axes.col(2)));
        const Double8 oriented = ((x * eight(frame.half[0]) + y * eight(frame.half[1])) + z * eight(frame.half[2])) +
                                 eight(16 * double_u) * ((size[row][0] + size[row][1]) + size[row][2]);
        const EightReaches h = eight_reaches(table.support, r[0], r[1], r[2]);
        const Double8 scale = eight(frame.scale), grown = eight(1 + 4 * double_u);
        const Double8 along = (smaller(h.along, oriented) * scale + delta) * grown;
        const Double8 against = (smaller(h.against, oriented) * scale + delta) * grown;
        ends[row + 3] = next_up_of_finite(center + along);
        ends[row] = negative(next_up_of_finite(negative(center - against)));
    }
    Double4 first[6], second[6];
    for (int end = 0; end < 6; ++end) {
        first[end] = low_half(ends[end]);
        second[end] = high_half(ends[end]);
    }
    store_four(first, boxes.data());
    store_four(second, boxes.data() + 4);
    return true;
}

}  // namespace ecods::support

#endif
