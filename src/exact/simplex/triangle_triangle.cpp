#include "ecods/primitives.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/point/posed_points.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/simplex/triangle_filter.hpp"
#include "exact/simplex/triangle_pair.hpp"

namespace ecods {
namespace {

using namespace exact;

const Pose in_place;

Relation decide(const PosedPoints<6>& exact, const RoundedPoints<6>& rounded) noexcept {
    const DeterminantBounds bounds = determinant_bounds(rounded.points, rounded.delta);
    FilterTrace trace;
    if (const auto relation = certain_relation(filter(rounded.points, bounds.orient3d, trace))) return *relation;
    return with_integers(exact, [&](const auto& integers) {
        TracedSigns signs(rounded.points, bounds, trace, integers);
        return triangle_pair(signs);
    });
}

PosedPoints<6> six(const Pose& pose_a, const std::array<Vec3, 3>& a, const Pose& pose_b,
                   const std::array<Vec3, 3>& b) noexcept {
    return {PointRef{&pose_a, &a[0]}, PointRef{&pose_a, &a[1]}, PointRef{&pose_a, &a[2]},
            PointRef{&pose_b, &b[0]}, PointRef{&pose_b, &b[1]}, PointRef{&pose_b, &b[2]}};
}

}  // namespace

Relation triangle_triangle(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) noexcept {
    const PosedPoints<6> points = six(in_place, a, in_place, b);
    return decide(points, plain_points(points));
}

Relation triangle_triangle(const PosedTriangle& a, const PosedTriangle& b) noexcept {
    const PosedPoints<6> points = six(a.pose, a.corners, b.pose, b.corners);
    return decide(points, round_points(points));
}

}  // namespace ecods
