#include "query/cast/turning_body.hpp"

#include "base/arithmetic.hpp"
#include "ecods/error.hpp"

namespace ecods {

double length_above(const Vec3& v) {
    const double square = v.squaredNorm(), length = square < 0x1p1000 ? std::sqrt(square) : sum_of(v);
    return length * (1 + 8 * two_u) + 0x1p-600;
}

namespace {

Vec3 axis_of(const exact::TurnAngles& angles) {
    const exact::Point& axis = angles.axis();
    return {axis[0], axis[1], axis[2]};
}

}  // namespace

void TurningBody::bind(const MeshTree& tree, const Mat3& R, const exact::TurnAngles& turn_angles,
                       const Vec3& pivot_at_start, const Vec3& way, double size_of_way, const Vec3& beside) {
    angles = &turn_angles;
    start = &R;
    pivot = pivot_at_start;
    glide = way;
    way_size = size_of_way;
    const Mat3 sizes = R.cwiseAbs();
    size = (sizes * tree.extent.magnitude).sum() + sum_of(beside);
    arm = sum_of(pivot);
    half = sizes * tree.extent.half;
    const Vec3 center = R * tree.extent.center - pivot;
    radius = (length_above(axis_of(turn_angles).cross(center)) + length_above(half)) + 128 * two_u * (size + arm);
    way_length = length_above(way) + 4 * two_u * way_size;
}

void TurningBody::require_moderate(double sizes) const {
    if (angles->condition_limit() > exact::TurnAngles::condition_max) {
        throw NotSupported("the turn is within some 2^-28 of a whole one: turn twice");
    }
    if (!angles->is_bounded()) throw NotSupported("the turn's quaternion has parts below 2^-500 or above 2^500");
    if (radius + way_length > 0x1p500 * sizes && sizes > 0) {
        throw NotSupported("the turn's pivot or glide is above 2^500 times as large as the bodies");
    }
}

MotionMargin::Across TurningBody::across(double sagitta) const {
    return {radius * sagitta * (1 + 16 * two_u), axis_of(*angles)};
}

TurningBody::Place TurningBody::place_at(const exact::HalfAngle& at) const {
    const Vec3 axis = axis_of(*angles);
    const double turned = 2 * at.sin * at.cos, inward = 2 * at.sin * at.sin;
    const auto way_of = [&](const Vec3& g) -> Vec3 {
        const Vec3 across = axis.cross(g);
        return turned * across + inward * axis.cross(across);
    };
    Place result;
    for (int k = 0; k < 3; ++k) result.R.col(k) = start->col(k) + way_of(start->col(k));
    result.t = at.time * glide - way_of(pivot);
    return result;
}

}  // namespace ecods
