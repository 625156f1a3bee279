// The support function by its table, for a few directions at once: what one box and four at once are made by. Always
// inlined: compiled for the instruction set of the caller (simd/dispatch.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bounds/double4.hpp"
#include "bounds/scaled_pose.hpp"
#include "bounds/support_table.hpp"
#include "simd/inline.hpp"

namespace ecods::support {

inline constexpr double double_u = 0x1p-52;  // one operation, any rounding mode
inline constexpr int cell_count = SupportTableGrid::cell_count, side_count = SupportTableGrid::side_count;
inline constexpr int middle = cell_count / 2;
inline constexpr double tiny = 0x1p-1000;              // below, a direction is one of no length
inline constexpr double table_error = 512 * double_u;  // of a value: see reaches()
using Row = std::array<float, SupportTableGrid::direction_count>;

// What a table holds, by reference.
struct TableView {
    const LocalFrame& frame;
    const Vec3& v_max;
    double v_max_of_all;
    const Row& support;
};

// Below these limits nothing overflows: the reach is at most 3 size_max in units of the scale, and below 1.5 sum_max.
// A mode that rounds down turns infinities into large numbers, which are above the limits, too.
inline constexpr double sum_limit = 0x1p1020, size_limit = 0x1p1000;

struct Reaches {
    Double4 along, against;
};

// h(d) and h(-d) for the rows d of R, from above, in units of the scale.
//
// Several rows at once, one in each of the first `row_count` lanes of x, y and z: the three of one R, or one of each of
// four. The table has both ends of each direction side by side: -d is in the same cell, with the same shares.
//
// Bound, with m = |d_axis| and u' = 2^-52: the factor to cells is off by u', a place in the grid by 17 u' (of 8 cells,
// each a quarter of m wide), what is left of it in a cell is exact, and the shares by 2 u'. So d and m sum l_k p_k
// differ by less than 8 u' m on each axis, worth 8 u' m 3 sqrt(3) < 42 u' m; the shares' errors and the roundings of
// the sum cost 8 u' m |h| < 24 u' m. 512 u' m covers all. Below 2^-1000, |h(d)| <= 3 m will do.
template <int row_count>
ECODS_ALWAYS_INLINE Reaches reaches(const Row& support, Double4 x, Double4 y, Double4 z) noexcept {
    const Double4 size_x = absolute(x), size_y = absolute(y), size_z = absolute(z);
    const Double4 size_xy = size_y > size_x ? size_y : size_x, m = size_z > size_xy ? size_z : size_xy;
    const auto is_y = size_y > size_x, is_z = size_z > size_xy;
    // The coordinate on the axis, those on the next two, and where the axis begins in the table.
    const auto by_axis = [&](Double4 a, Double4 b, Double4 c) { return is_z ? c : is_y ? b : a; };
    const Double4 none{}, one = none + 1;
    const auto is_tiny = m < none + tiny;
    const Double4 d = is_tiny ? one : by_axis(x, y, z);
    constexpr auto face = static_cast<double>(SupportTableGrid::face_size);
    const Double4 start = by_axis(none, none + face, none + 2 * face);

    const Double4 to_cells = middle / d;
    const auto place = [&](Double4 coordinate) {
        const Double4 at = coordinate * to_cells + middle, end = none + cell_count;
        return at > none ? (at < end ? at : end) : none;
    };
    using Int4 = Vec<std::int32_t, 4>;
    const auto whole = [](Double4 at) { return convert<Double4>(convert<Int4>(at)); };
    const Double4 at_i = place(by_axis(y, z, x)), at_j = place(by_axis(z, x, y));
    const Double4 last = none + (cell_count - 1), floor_i = whole(at_i), floor_j = whole(at_j);
    const Double4 i = floor_i < last ? floor_i : last, j = floor_j < last ? floor_j : last;
    const Double4 f = at_i - i, g = at_j - j;

    // Each cell is cut along its diagonal.
    const Double4 low = f < g ? f : g, high = f < g ? g : f;
    const Double4 first_share = 1 - high, across_share = high - low;
    const Int4 first = convert<Int4>(start + side_count * j + i);
    const Int4 across = first + convert<Int4>(f < g ? none + side_count : one);
    const auto table = [&](int at) {
        const float* const h = &support[2 * static_cast<std::size_t>(at)];
        return Double2{h[0], h[1]};
    };
    const auto both = [&](int k) {
        return (first_share[k] * table(first[k]) + across_share[k] * table(across[k])) +
               low[k] * table(first[k] + side_count + 1);
    };
    const Double2 last_row = row_count == 4 ? both(3) : Double2{};
    const Double2 h[4] = {both(0), both(1), both(2), last_row};
    const Double4 up = {h[0][0], h[1][0], h[2][0], h[3][0]}, down = {h[0][1], h[1][1], h[2][1], h[3][1]};
    const auto is_negative = d < none;
    const Double4 along = is_negative ? down : up, against = is_negative ? up : down;
    return {.along = is_tiny ? 4 * m : m * (along + table_error),
            .against = is_tiny ? 4 * m : m * (against + table_error)};
}

}  // namespace ecods::support
