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
// All three rows of R at once: row k in lane k of x, y and z. The table has both ends of each direction side by side:
// -d is in the same cell, with the same shares.
//
// Bound, with m = |d_axis| and u' = 2^-52: the factor to cells is off by u', a place in the grid by 17 u' (of 8 cells,
// each a quarter of m wide), what is left of it in a cell is exact, and the shares by 2 u'. So d and m sum l_k p_k
// differ by less than 8 u' m on each axis, worth 8 u' m 3 sqrt(3) < 42 u' m; the shares' errors and the roundings of
// the sum cost 8 u' m |h| < 24 u' m. 512 u' m covers all. Below 2^-1000, |h(d)| <= 3 m will do.
ECODS_ALWAYS_INLINE Reaches reaches(const Row& support, Double4 x, Double4 y, Double4 z) noexcept {
    const Double4 size_x = absolute(x), size_y = absolute(y), size_z = absolute(z);
    const Double4 size_xy = size_y > size_x ? size_y : size_x, m = size_z > size_xy ? size_z : size_xy;
    const auto is_y = size_y > size_x, is_z = size_z > size_xy;
    // The coordinate on the axis, those on the next two, and where the axis begins in the table.
    const auto by_axis = [&](Double4 a, Double4 b, Double4 c) { return is_z ? c : is_y ? b : a; };
    const Double4 none{}, one = none + 1;
    const auto is_tiny = m < none + 0x1p-1000;
    const Double4 d = is_tiny ? one : by_axis(x, y, z);
    const Double4 start = by_axis(none, none + face_size, none + 2 * face_size);

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
    const Double2 h[3] = {both(0), both(1), both(2)};
    const Double4 up = {h[0][0], h[1][0], h[2][0], 0}, down = {h[0][1], h[1][1], h[2][1], 0};
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
    const Reaches h = reaches(table.support, R.column[0], R.column[1], R.column[2]);
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

}  // namespace ecods
