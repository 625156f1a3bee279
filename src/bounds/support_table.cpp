#include "bounds/support_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/assert.hpp"
#include "base/next.hpp"
#include "base/outward.hpp"
#include "bounds/support_lanes.hpp"
#include "geometry/used_vertices.hpp"
#include "simd/double8.hpp"

#define ECODS_TEXT "bounds/support_table_text.hpp"
#include "simd/each_set.hpp"

#if ECODS_CAN_DISPATCH
ECODS_BEGIN_WIDE
namespace ecods::wide {
#include "bounds/double4_text.hpp"
#include "bounds/support_lanes_text.hpp"

#include "bounds/eight_boxes_text.hpp"
}  // namespace ecods::wide
ECODS_END_REGION
#endif

namespace ecods {
namespace {

using namespace support;

constexpr double float_u = 0x1p-23;
constexpr std::size_t face_size = SupportTableGrid::face_size, direction_count = SupportTableGrid::direction_count;

// Returns the box of the pose, computed from a pose that is scaled such that its sums are about one. With v_max between
// 2^-900 and 2^902, entries of R are below 2^901, and the bound's term for underflow is below 2^-90 of the bound.
[[gnu::noinline]] Aabb scaled_box_by_table(const TableView& table, const Pose& pose) {
    const ScaledPose scaled(pose, table.v_max, false);
    if (scaled.is_zero()) return {};
    Aabb box;
    [[maybe_unused]] const bool is_found = call_widest<ECODS_OF_EACH_SET(find_box)>(table, scaled.pose(), box);
    ECODS_ASSERT(is_found);
    return scaled.unscaled(box);
}

}  // namespace

// Computes the values of the table, which have rounding errors: points are y = (v - center) / scale, so |y| <= sqrt(3),
// and
// |direction| <= sqrt(3). With v = 2^-23, rounding the point to floats costs 1.01 v of each coordinate, and the product
// 3.01 v: together below 4.1 v sum |direction_k y_k| <= 4.1 v 3 < 13 v.
// Claim: verify/proofs/float_determinants.py
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
        call_widest<ECODS_OF_EACH_SET(include)>(directions[0], directions[1], directions[2], point, support_);
    });
    for (float& h : support_) h = round_up(static_cast<double>(h) + 13 * float_u);
    v_max_ = frame.center.cwiseAbs() + Vec3::Constant(2 * frame.scale);
    v_max_of_all_ = v_max_.maxCoeff();
}

Aabb SupportTable::box(const Pose& pose) const {
    const TableView view{frame_, v_max_, v_max_of_all_, support_};
    Aabb box;
    if (!call_widest<ECODS_OF_EACH_SET(find_box)>(view, pose, box)) [[unlikely]]
        box = scaled_box_by_table(view, pose);
    return box;
}

namespace {

// Computes the boxes of all poses: calls boxes_of(poses, boxes) with `width` poses at a time. If fewer poses are left,
// the last pose is repeated; for a single pose that is left, the box is computed by table.box(). boxes_of() returns
// false if one of its poses must be scaled; then the boxes of that group are computed one by one.
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
            return wide::find_eight_boxes(view, eight_poses, eight_boxes);
        });
    }
#endif
    find_boxes<4>(*this, poses, boxes, [&](const auto& four_poses, const auto& four_boxes) {
        return call_widest<ECODS_OF_EACH_SET(find_four_boxes)>(view, four_poses, four_boxes);
    });
}

}  // namespace ecods
