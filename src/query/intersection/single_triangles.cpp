#include "query/intersection/single_triangles.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "exact/point/point.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/simplex/triangle_filter.hpp"

namespace ecods {

using namespace exact;

namespace {

// Poses the corners of triangle `index`, and stores them in `points` from `first` on. Returns their error bound.
ECODS_ALWAYS_INLINE double pose_corners(const Mesh& mesh, std::uint32_t index, const Pose& pose, const Vec3& offset,
                                        std::array<Point, 6>& points, std::size_t first) noexcept {
    const Triangle& triangle = mesh.triangles()[index];
    Vec3 magnitude = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& v = mesh.vertices()[triangle[i]];
        points[first + i] = pose_point(pose.R, v, offset);
        magnitude = magnitude.cwiseMax(v.cwiseAbs());
    }
    return point_error_bound(pose.R, magnitude, offset);
}

}  // namespace

std::optional<Relation> filter_triangles(const Mesh& a, std::uint32_t i, const Pose& pose_a, const Mesh& b,
                                         std::uint32_t j, const Pose& pose_b) noexcept {
    ECODS_ASSERT(i < a.triangles().size() && j < b.triangles().size());
    Points<6> points;
    const double delta_a = pose_corners(a, i, pose_a, Vec3::Zero(), points, 0);
    const double delta_b = pose_corners(b, j, pose_b, pose_b.t - pose_a.t, points, 3);
    const DeterminantBounds bounds = determinant_bounds(points, std::max(delta_a, delta_b));
    FilterTrace trace;
    return certain_relation(filter(points, bounds.orient3d, trace));
}

}  // namespace ecods
