#include "ecods/predicates.hpp"
#include "exact/point/integer_width.hpp"
#include "exact/point/rounded_points.hpp"
#include "exact/sign/filter.hpp"
#include "exact/sign/filtered_signs.hpp"
#include "exact/simplex/triangle_pair.hpp"

namespace ecods {
namespace {

using namespace exact;

const Pose identity;

Relation decide(const SixPoints& exact, const RoundedPoints& rounded) noexcept {
    const PairBound bound = pair_bound(rounded.points, rounded.delta);
    FilterTrace trace;
    switch (filter(rounded.points, bound.orient3d, trace)) {
        case FilterAnswer::disjoint:
            return Relation::disjoint;
        case FilterAnswer::crossing:
            return Relation::crossing;
        case FilterAnswer::unknown:
            break;
    }
    return with_kernel(exact, [&](const auto& kernel) {
        FilteredSigns signs(rounded.points, bound, trace, kernel);
        return triangle_pair(signs);
    });
}

SixPoints six(const Pose& pose_a, const std::array<Vec3, 3>& a, const Pose& pose_b,
              const std::array<Vec3, 3>& b) noexcept {
    return {PointRef{&pose_a, &a[0]}, PointRef{&pose_a, &a[1]}, PointRef{&pose_a, &a[2]},
            PointRef{&pose_b, &b[0]}, PointRef{&pose_b, &b[1]}, PointRef{&pose_b, &b[2]}};
}

}  // namespace

Relation triangle_triangle(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) noexcept {
    const SixPoints points = six(identity, a, identity, b);
    return decide(points, plain_points(points));
}

Relation triangle_triangle(const PosedTriangle& a, const PosedTriangle& b) noexcept {
    const SixPoints points = six(a.pose, a.corners, b.pose, b.corners);
    return decide(points, round_points(points));
}

}  // namespace ecods
