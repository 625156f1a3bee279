#include "bounds/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/dispatch.hpp"
#include "bounds/next.hpp"
#include "bounds/outward.hpp"
#include "exact/filter_bound.hpp"
#include "exact/pose_point.hpp"

namespace ecods {
namespace {

constexpr double double_u = 0x1p-52;  // one operation, any rounding mode
constexpr double float_u = 0x1p-23;
constexpr std::size_t direction_count = 6 * 81;
using Row = std::array<float, direction_count>;

// reach[k] = max(reach[k], direction k . y).
ECODS_FOR_EACH_INSTRUCTION_SET
void include(const Row& x, const Row& y, const Row& z, const std::array<float, 3>& point, Row& reach) noexcept {
    for (std::size_t k = 0; k < direction_count; ++k) {
        const float at = (x[k] * point[0] + y[k] * point[1]) + z[k] * point[2];
        reach[k] = at > reach[k] ? at : reach[k];
    }
}

}  // namespace

// Points are (v - center) / scale, so |y| <= sqrt(3), and |direction| <= sqrt(3). Rounding the point costs 1.01 v of
// each coordinate (v = 2^-23), the product 3.01 v: below 4.1 v sum |direction_k y_k| <= 4.1 v 3 < 13 v.
Outline::Outline(const Mesh& mesh, const TreeFrame& frame) : frame_(frame) {
    static_assert(6 * face_size == direction_count);
    std::array<Row, 3> directions;
    for (std::size_t face = 0; face < 6; ++face) {
        const std::size_t axis = face / 2;
        for (std::size_t i = 0; i < face_size; ++i) {
            const std::size_t at = face * face_size + i;
            directions[axis][at] = face % 2 == 0 ? 1.0f : -1.0f;
            directions[(axis + 1) % 3][at] = static_cast<float>(i % side_count) * (2.0f / cell_count) - 1;
            directions[(axis + 2) % 3][at] = static_cast<float>(i / side_count) * (2.0f / cell_count) - 1;
        }
    }
    support_.fill(-std::numeric_limits<float>::infinity());
    const auto include_vertex = [&](const Vec3& v) {
        const Vec3 y = (v - frame.center) / frame.scale;
        include(directions[0], directions[1], directions[2],
                {static_cast<float>(y[0]), static_cast<float>(y[1]), static_cast<float>(y[2])}, support_);
    };
    if (mesh.uses_all_vertices()) {
        for (const Vec3& v : mesh.vertices()) include_vertex(v);
    } else {
        for (const Triangle& triangle : mesh.triangles()) {
            for (const std::uint32_t index : triangle) include_vertex(mesh.vertices()[index]);
        }
    }
    for (float& h : support_) h = round_up(static_cast<double>(h) + 13 * float_u);
}

// h(d), from above, in units of the scale.
//
// Bound: m is exact; the two coordinates over m are off by u' = 2^-52, their places in the grid by 9 u' (of 8 cells),
// the three shares by 20 u'. So d and m sum l_k p_k differ by less than 64 u' m on each axis, worth 64 u' m 3 sqrt(3) <
// 340 u' m; the shares' errors and the roundings of the sum cost 40 u' m |h| < 120 u' m. 512 u' m covers all.
double Outline::reach(const Vec3& d) const {
    Eigen::Index axis = 0;
    const double m = d.cwiseAbs().maxCoeff(&axis);
    if (m == 0) return 0;
    const auto place = [&](double x, int& cell) {
        const double at = (x / m + 1) * (cell_count / 2);
        cell = std::clamp(static_cast<int>(at), 0, cell_count - 1);
        return std::clamp(at - cell, 0.0, 1.0);
    };
    int i = 0, j = 0;
    const double f = place(d[(axis + 1) % 3], i), g = place(d[(axis + 2) % 3], j);
    const auto face = static_cast<std::size_t>(2 * axis + (d[axis] < 0 ? 1 : 0));
    const auto at = [&](int x, int y) {
        return static_cast<double>(support_[face * face_size + static_cast<std::size_t>(y * side_count + x)]);
    };
    // Each cell is cut along its diagonal.
    const double low = std::min(f, g), high = std::max(f, g);
    const double across = f >= g ? at(i + 1, j) : at(i, j + 1);
    return m * (((1 - high) * at(i, j) + (high - low) * across + low * at(i + 1, j + 1)) + 512 * double_u);
}

// The center is posed with the error of a point (exact/filter_bound.hpp), and so would any point of the mesh be, whose
// coordinates are below |center| + 2 scale: that bound's term for underflow covers the reach, too. The oriented box
// reaches |R axes| half from the center: both products are off by 3.01 u' sqrt(3) |R| 1, below 16 u' |R| 1 in units of
// the scale.
Aabb Outline::box(const Pose& pose) const {
    Aabb box;
    const double scale = frame_.scale;
    const exact::Point center = exact::pose_point(pose.R, frame_.center, pose.t);
    const Vec3 v_max = frame_.center.cwiseAbs() + Vec3::Constant(2 * scale);
    const double delta = exact::point_error_bound(pose.R, v_max, pose.t);
    const Mat3 turned = (pose.R * frame_.axes).cwiseAbs();
    const auto outwards = [&](double units) { return next_up(next_up(units * scale) + delta); };
    for (int k = 0; k < 3; ++k) {
        const Vec3 row = pose.R.row(k);
        const double oriented = turned.row(k).dot(frame_.half) + 16 * double_u * row.cwiseAbs().sum();
        const double c = center[static_cast<std::size_t>(k)];
        box.max[k] = next_up(c + outwards(std::min(reach(row), oriented)));
        box.min[k] = next_down(c - outwards(std::min(reach(-row), oriented)));
    }
    // NaN comes with numbers that are too large only.
    if (!(box.min.cwiseAbs().sum() + box.max.cwiseAbs().sum() < std::numeric_limits<double>::infinity())) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return {Vec3::Constant(-infinity), Vec3::Constant(infinity)};
    }
    return box;
}

}  // namespace ecods
