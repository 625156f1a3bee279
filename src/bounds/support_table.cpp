#include "bounds/support_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/assert.hpp"
#include "base/next.hpp"
#include "base/outward.hpp"
#include "bounds/eight_boxes.hpp"
#include "bounds/four_boxes.hpp"
#include "bounds/support_lanes.hpp"
#include "exact/point/point.hpp"
#include "geometry/used_vertices.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

using namespace support;

constexpr double float_u = 0x1p-23;
constexpr std::size_t face_size = SupportTableGrid::face_size, direction_count = SupportTableGrid::direction_count;

// reach[k] = max(reach[k], direction k . y).
ECODS_ALWAYS_INLINE void include(const Row& x, const Row& y, const Row& z, const std::array<float, 3>& point,
                                 Row& reach) noexcept {
    for (std::size_t k = 0; k < direction_count; ++k) {
        const float at = (x[k] * point[0] + y[k] * point[1]) + z[k] * point[2];
        reach[k] = at > reach[k] ? at : reach[k];
    }
}

// The center is posed with the error of a point (exact/point/point.hpp), as any point of the mesh would be, whose
// coordinates are below |center| + 2 scale: the bound's term for underflow covers the reach, too. The oriented box
// reaches |R axes| half from the center: both products are off by 3.01 u' sqrt(3) |R| 1, below 16 u' |R| 1 in units of
// the scale. The reach that is added to the center has three roundings, below 4 u', and the sum has one.
ECODS_ALWAYS_INLINE Aabb box_by_table(const TableView& table, const Matrix4& R, Double4 t, const Matrix4& size,
                                      double delta) noexcept {
    const Double4 center = R * load3(table.frame.center.data()) + t;  // as pose_point has it
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

// Sets the box, unless the pose must be scaled for it.
ECODS_ALWAYS_INLINE bool find_box(const TableView& table, const Pose& pose, Aabb& box) noexcept {
    const Matrix4 R = load3(pose.R), size = absolute(R);
    const Double4 t = load3(pose.t.data());
    const double sum_max = largest(size * load3(table.v_max.data()) + absolute(t)), size_max = largest(size);
    const double factor_max = std::max(size_max, table.v_max_of_all);
    const double delta = exact::point_error_bound(sum_max, factor_max);
    if (!(sum_max < sum_limit && size_max < size_limit && delta > unscaled_min + unscaled_min * factor_max)) {
        return false;
    }
    box = box_by_table(table, R, t, size, delta);
    return true;
}

// The pose in units in which its sums are about one: with v_max between 2^-900 and 2^902, entries of R are below 2^901,
// and the term for underflow is below 2^-90 of the bound.
[[gnu::noinline]] Aabb scaled_box_by_table(const TableView& table, const Pose& pose) {
    const ScaledPose scaled(pose, table.v_max, false);
    if (scaled.is_zero()) return {};
    Aabb box;
    [[maybe_unused]] const bool is_found = dispatch<find_box>(table, scaled.pose(), box);
    ECODS_ASSERT(is_found);
    return scaled.unscaled(box);
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
    for_each_used_vertex(mesh, [&](std::uint32_t index) {
        const Vec3 y = (mesh.vertices()[index] - frame.center) / frame.scale;
        const std::array<float, 3> point{static_cast<float>(y[0]), static_cast<float>(y[1]), static_cast<float>(y[2])};
        dispatch<include>(directions[0], directions[1], directions[2], point, support_);
    });
    for (float& h : support_) h = round_up(static_cast<double>(h) + 13 * float_u);
    v_max_ = frame.center.cwiseAbs() + Vec3::Constant(2 * frame.scale);
    v_max_of_all_ = v_max_.maxCoeff();
}

Aabb SupportTable::box(const Pose& pose) const {
    const TableView view{frame_, v_max_, v_max_of_all_, support_};
    Aabb box;
    if (!dispatch<find_box>(view, pose, box)) [[unlikely]]
        box = scaled_box_by_table(view, pose);
    return box;
}

namespace {

// Calls `boxes_of` with `width` poses at a time, of which the last ones repeat where there are fewer; it returns
// whether that can be done. One that is left is asked for alone, and so are all where one must be scaled.
template <std::size_t width, class BoxesOf>
void find_boxes(const SupportTable& table, std::span<const Pose* const> poses, std::span<Aabb* const> boxes,
                const BoxesOf& boxes_of) {
    for (std::size_t begin = 0; begin < poses.size(); begin += width) {
        const std::size_t count = std::min(width, poses.size() - begin);
        std::array<const Pose*, width> some_poses;
        std::array<Aabb*, width> some_boxes;
        for (std::size_t i = 0; i < width; ++i) {
            some_poses[i] = poses[begin + std::min(i, count - 1)];
            some_boxes[i] = boxes[begin + std::min(i, count - 1)];
        }
        if (count > 1 && boxes_of(some_poses, some_boxes)) continue;
        for (std::size_t i = 0; i < count; ++i) *some_boxes[i] = table.box(*some_poses[i]);
    }
}

}  // namespace

void SupportTable::boxes(std::span<const Pose* const> poses, std::span<Aabb* const> boxes) const {
    const TableView view{frame_, v_max_, v_max_of_all_, support_};
#if ECODS_CAN_DISPATCH
    if (read_instruction_set() == InstructionSet::avx512) {
        return find_boxes<8>(*this, poses, boxes, [&](const auto& eight_poses, const auto& eight_boxes) {
            return eight_boxes_by_table(view, eight_poses, eight_boxes);
        });
    }
#endif
    find_boxes<4>(*this, poses, boxes, [&](const auto& four_poses, const auto& four_boxes) {
        return dispatch<four_boxes_by_table>(view, four_poses, four_boxes);
    });
}

}  // namespace ecods
