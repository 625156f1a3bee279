#include "query/intersection/single_triangles.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "exact/point/point.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/simplex/triangle_filter.hpp"

namespace ecods {

using namespace exact;

namespace {

// Poses the corners of the mesh's triangle, and returns the bound of their error.
ECODS_ALWAYS_INLINE double pose_corners(const Mesh& mesh, const Pose& pose, const Vec3& offset,
                                        std::array<Point, 6>& points, std::size_t first) noexcept {
    const Triangle& triangle = mesh.triangles().front();
    Vec3 magnitude = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& v = mesh.vertices()[triangle[i]];
        points[first + i] = pose_point(pose.R, v, offset);
        magnitude = magnitude.cwiseMax(v.cwiseAbs());
    }
    return point_error_bound(pose.R, magnitude, offset);
}

}  // namespace

std::optional<Relation> filter_single_triangles(const Mesh& a, const Pose& pose_a, const Mesh& b,
                                                const Pose& pose_b) noexcept {
    ECODS_ASSERT(a.triangles().size() == 1 && b.triangles().size() == 1);
    Points<6> points;
    const double delta_a = pose_corners(a, pose_a, Vec3::Zero(), points, 0);
    const double delta_b = pose_corners(b, pose_b, pose_b.t - pose_a.t, points, 3);
    const DeterminantBounds bounds = determinant_bounds(points, std::max(delta_a, delta_b));
    FilterTrace trace;
    switch (filter(points, bounds.orient3d, trace)) {
        case FilterAnswer::disjoint:
            return Relation::disjoint;
        case FilterAnswer::crossing:
            return Relation::crossing;
        case FilterAnswer::unknown:
            break;
    }
    return std::nullopt;
}

}  // namespace ecods
