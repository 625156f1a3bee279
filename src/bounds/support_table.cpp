#include "bounds/support_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/next.hpp"
#include "base/outward.hpp"
#include "bounds/double4.hpp"
#include "exact/point/point.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

constexpr double double_u = 0x1p-52;  // one operation, any rounding mode
constexpr double float_u = 0x1p-23;
constexpr int cell_count = SupportTableGrid::cell_count, side_count = SupportTableGrid::side_count;
constexpr int middle = cell_count / 2;
constexpr std::size_t face_size = SupportTableGrid::face_size, direction_count = SupportTableGrid::direction_count;
using Row = std::array<float, direction_count>;

// reach[k] = max(reach[k], direction k . y).
ECODS_ALWAYS_INLINE void include(const Row& x, const Row& y, const Row& z, const std::array<float, 3>& point,
                                 Row& reach) noexcept {
    for (std::size_t k = 0; k < direction_count; ++k) {
        const float at = (x[k] * point[0] + y[k] * point[1]) + z[k] * point[2];
        reach[k] = at > reach[k] ? at : reach[k];
    }
}

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
    const auto is_tiny = m < none + 0x1p-1000;
    const Double4 d = is_tiny ? one : by_axis(x, y, z);
    constexpr auto face = static_cast<double>(face_size);
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
    return {.along = is_tiny ? 4 * m : m * (along + 512 * double_u),
            .against = is_tiny ? 4 * m : m * (against + 512 * double_u)};
}

// What a table holds, by reference.
struct TableView {
    const LocalFrame& frame;
    const Vec3& v_max;
    double v_max_of_all;
    const Row& support;
};

// The center is posed with the error of a point (exact/point/point.hpp), as any point of the mesh would be, whose
// coordinates are below |center| + 2 scale: the bound's term for underflow covers the reach, too. The oriented box
// reaches |R axes| half from the center: both products are off by 3.01 u' sqrt(3) |R| 1, below 16 u' |R| 1 in units of
// the scale. The reach that is added to the center has three roundings, below 4 u', and the sum has one.
ECODS_ALWAYS_INLINE Aabb box_by_table(const TableView& table, const Pose& pose) noexcept {
    const Matrix4 R = load3(pose.R);
    const Double4 t = load3(pose.t.data());
    const Double4 center = R * load3(table.frame.center.data()) + t;  // as pose_point has it
    const Matrix4 size = absolute(R);
    const double sum_max = largest(size * load3(table.v_max.data()) + absolute(t));
    const double size_max = largest(size);
    // Below these limits nothing overflows: the reach is at most 3 size_max in units of the scale, and below 1.5
    // sum_max. Checked in advance, because a mode that rounds down turns infinities into large numbers.
    if (!(sum_max < 0x1p1020 && size_max < 0x1p1000)) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return {Vec3::Constant(-infinity), Vec3::Constant(infinity)};
    }
    const double delta = exact::point_error_bound(sum_max, std::max(size_max, table.v_max_of_all));
    const Double4 oriented =
        absolute(R * load3(table.frame.axes)) * load3(table.frame.half.data()) + 16 * double_u * row_sums(size);
    const Reaches h = reaches<3>(table.support, R.column[0], R.column[1], R.column[2]);
    const auto outwards = [&](Double4 units) {
        return ((units < oriented ? units : oriented) * table.frame.scale + delta) * (1 + 4 * double_u);
    };
    const Double4 max = center + outwards(h.along), min = center - outwards(h.against);
    Aabb box;
    for (int k = 0; k < 3; ++k) {
        box.max[k] = next_up(max[k]);
        box.min[k] = next_down(min[k]);
    }
    return box;
}

// ---- four poses at once: lane i is the i-th one's. Each number is made by the same operations in the same order as
// for one pose, so the boxes are the same bits.

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
    using Bits = Vec<std::int64_t, 4>;
    const Bits bits = bits_as<Bits>(x), zero{}, one = zero + 1;
    const Bits next = bits < zero ? bits - 1 : bits + 1;
    return bits_as<Double4>(bits + bits == zero ? one : next);
}
ECODS_ALWAYS_INLINE Double4 negative(Double4 x) noexcept {
    using Bits = Vec<std::uint64_t, 4>;
    return bits_as<Double4>(bits_as<Bits>(x) ^ (std::uint64_t{1} << 63));
}

// Returns whether all four are bounded; otherwise the boxes are not set.
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
    if (!all((sum_max < none + 0x1p1020) & (size_max < none + 0x1p1000))) return false;
    const Double4 factor_max = larger(size_max, none + table.v_max_of_all);
    // point_error_bound
    const Double4 underflow = factor_max < none + 0x1p19 ? none + 0x1p-1000 : 0x1p-1000 + 0x1p-1000 * factor_max;
    const Double4 delta = 4.25 * double_u * sum_max + underflow;
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

}  // namespace

// Points are (v - center) / scale, so |y| <= sqrt(3), and |direction| <= sqrt(3). Rounding the point costs 1.01 v of
// each coordinate (v = 2^-23), the product 3.01 v: below 4.1 v sum |direction_k y_k| <= 4.1 v 3 < 13 v.
SupportTable::SupportTable(const Mesh& mesh, const LocalFrame& frame) : frame_(frame) {
    std::array<Row, 3> directions;
    for (std::size_t at = 0; at < direction_count; ++at) {
        const std::size_t axis = at / 2 / face_size, i = at / 2 % face_size;
        const std::size_t column = i % side_count, row = i / side_count;
        const float sign = at % 2 == 0 ? 1.0f : -1.0f;
        directions[axis][at] = sign;
        directions[(axis + 1) % 3][at] = sign * (static_cast<float>(column) * (2.0f / cell_count) - 1);
        directions[(axis + 2) % 3][at] = sign * (static_cast<float>(row) * (2.0f / cell_count) - 1);
    }
    support_.fill(-std::numeric_limits<float>::infinity());
    const auto include_vertex = [&](const Vec3& v) {
        const Vec3 y = (v - frame.center) / frame.scale;
        const std::array<float, 3> point{static_cast<float>(y[0]), static_cast<float>(y[1]), static_cast<float>(y[2])};
        dispatch<include>(directions[0], directions[1], directions[2], point, support_);
    };
    if (mesh.uses_all_vertices()) {
        for (const Vec3& v : mesh.vertices()) include_vertex(v);
    } else {
        for (const Triangle& triangle : mesh.triangles()) {
            for (const std::uint32_t index : triangle) include_vertex(mesh.vertices()[index]);
        }
    }
    for (float& h : support_) h = round_up(static_cast<double>(h) + 13 * float_u);
    v_max_ = frame.center.cwiseAbs() + Vec3::Constant(2 * frame.scale);
    v_max_of_all_ = v_max_.maxCoeff();
}

Aabb SupportTable::box(const Pose& pose) const {
    return dispatch<box_by_table>(TableView{frame_, v_max_, v_max_of_all_, support_}, pose);
}

void SupportTable::boxes(const std::array<const Pose*, 4>& poses, const std::array<Aabb*, 4>& boxes) const {
    const TableView view{frame_, v_max_, v_max_of_all_, support_};
    if (dispatch<four_boxes_by_table>(view, poses, boxes)) return;
    for (std::size_t i = 0; i < 4; ++i) *boxes[i] = box(*poses[i]);
}

}  // namespace ecods
