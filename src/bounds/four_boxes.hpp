// The boxes of four poses at once: lane i is the i-th one's. Each number is made by the same operations in the same
// order as for one pose, so the boxes are the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bounds/support_lanes.hpp"
#include "exact/point/point.hpp"

namespace ecods::support {

struct RowsOfFour {
    Double4 R[3][3], t[3];  // by row, and column
};

ECODS_ALWAYS_INLINE void transpose4(const double* const (&rows)[4], Double4 (&columns)[4]) noexcept {
    const Double4 a = load_anywhere<Double4>(rows[0]), b = load_anywhere<Double4>(rows[1]);
    const Double4 c = load_anywhere<Double4>(rows[2]), d = load_anywhere<Double4>(rows[3]);
    const Double4 ab_low = shuffle<0, 4, 2, 6>(a, b), ab_high = shuffle<1, 5, 3, 7>(a, b);
    const Double4 cd_low = shuffle<0, 4, 2, 6>(c, d), cd_high = shuffle<1, 5, 3, 7>(c, d);
    columns[0] = shuffle<0, 1, 4, 5>(ab_low, cd_low);
    columns[1] = shuffle<0, 1, 4, 5>(ab_high, cd_high);
    columns[2] = shuffle<2, 3, 6, 7>(ab_low, cd_low);
    columns[3] = shuffle<2, 3, 6, 7>(ab_high, cd_high);
}

ECODS_ALWAYS_INLINE RowsOfFour load_four(const std::array<const Pose*, 4>& poses) noexcept {
    static_assert(sizeof(Pose) == 12 * sizeof(double), "R by columns, then t: three registers of four");
    RowsOfFour rows;
    for (int part = 0; part < 3; ++part) {
        const double* numbers[4];
        for (std::size_t i = 0; i < 4; ++i) numbers[i] = poses[i]->R.data() + 4 * part;
        Double4 columns[4];
        transpose4(numbers, columns);
        for (int k = 0; k < 4; ++k) {
            const int at = 4 * part + k;
            (at < 9 ? rows.R[at % 3][at / 3] : rows.t[at - 9]) = columns[k];
        }
    }
    return rows;
}

ECODS_ALWAYS_INLINE Double4 larger(Double4 a, Double4 b) noexcept {
    return a > b ? a : b;
}

// next_up(x) of what is neither infinite nor NaN, and next_down(x) = -next_up(-x).
ECODS_ALWAYS_INLINE Double4 next_up_of_finite(Double4 x) noexcept {
    using Bits = Vec<std::uint64_t, 4>;
    const Bits bits = bits_as<Bits>(x), zero{}, one = zero + 1;
    const Bits next = bits_as<Vec<std::int64_t, 4>>(x) < 0 ? bits - 1 : bits + 1;
    return bits_as<Double4>(bits + bits == zero ? one : next);
}
ECODS_ALWAYS_INLINE Double4 negative(Double4 x) noexcept {
    using Bits = Vec<std::uint64_t, 4>;
    return bits_as<Double4>(bits_as<Bits>(x) ^ (std::uint64_t{1} << 63));
}

// Returns whether no pose need be scaled for its box; otherwise the boxes are not set.
ECODS_ALWAYS_INLINE bool four_boxes_by_table(const TableView& table, const std::array<const Pose*, 4>& poses,
                                             const std::array<Aabb*, 4>& boxes) noexcept {
    const RowsOfFour rows = load_four(poses);
    const LocalFrame& frame = table.frame;
    Double4 size[3][3], sum_max{}, size_max{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            size[row][column] = absolute(rows.R[row][column]);
            size_max = larger(size_max, size[row][column]);
        }
        const Double4* const s = size[row];
        const Double4 sum = (s[0] * table.v_max[0] + s[1] * table.v_max[1]) + s[2] * table.v_max[2];
        sum_max = larger(sum_max, sum + absolute(rows.t[row]));
    }
    const Double4 none{};
    const Double4 factor_max = larger(size_max, none + table.v_max_of_all);
    // point_error_bound
    const Double4 underflow = factor_max < none + 0x1p19 ? none + 0x1p-1000 : 0x1p-1000 + 0x1p-1000 * factor_max;
    const Double4 delta = 4.25 * double_u * sum_max + underflow;
    const auto is_low = (sum_max < none + sum_limit) & (size_max < none + size_limit);
    if (!all(is_low & (delta > unscaled_min + unscaled_min * factor_max))) return false;
    for (int row = 0; row < 3; ++row) {
        const Double4* const r = rows.R[row];
        const auto times = [&](const Vec3& v) { return (r[0] * v[0] + r[1] * v[1]) + r[2] * v[2]; };
        const Double4 center = times(frame.center) + rows.t[row];
        const Double4 x = absolute(times(frame.axes.col(0))), y = absolute(times(frame.axes.col(1))),
                      z = absolute(times(frame.axes.col(2)));
        const Double4 oriented = ((x * frame.half[0] + y * frame.half[1]) + z * frame.half[2]) +
                                 16 * double_u * ((size[row][0] + size[row][1]) + size[row][2]);
        const Reaches h = reaches<4>(table.support, r[0], r[1], r[2]);
        const auto outwards = [&](Double4 units) {
            return ((units < oriented ? units : oriented) * frame.scale + delta) * (1 + 4 * double_u);
        };
        const Double4 max = next_up_of_finite(center + outwards(h.along));
        const Double4 min = negative(next_up_of_finite(negative(center - outwards(h.against))));
        for (int i = 0; i < 4; ++i) {
            boxes[static_cast<std::size_t>(i)]->max[row] = max[i];
            boxes[static_cast<std::size_t>(i)]->min[row] = min[i];
        }
    }
    return true;
}

}  // namespace ecods::support
