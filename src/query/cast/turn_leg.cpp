#include "query/cast/turn_leg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/double_key.hpp"
#include "exact/measure/round/long_rounding.hpp"
#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"
#include "query/cast/exact_quaternion.hpp"

namespace ecods {
namespace {

using exact::exact_vector;
using exact::ScaledInteger;
using exact::ScaledLongVector;

double rounded(const ScaledInteger& num, const ScaledInteger& den) {
    const double x = exact::round_quotient(num, den);
    return key_of(x) == 0 && num.sign() != 0 ? num.sign() * std::numeric_limits<double>::denorm_min() : x;
}

Vec3 rounded(const ScaledLongVector& num, const ScaledInteger& den) {
    return {rounded(num[0], den), rounded(num[1], den), rounded(num[2], den)};
}

// Returns the quaternion of the rotation from z0 to z1; each component is rounded once.
Quaternion quotient(const ExactQuaternion& z1, const ExactQuaternion& z0) {
    const ExactQuaternion z = times_conjugate(z1, z0);
    const ScaledInteger norm = z0.norm();
    const Vec3 v = rounded(z.v, norm);
    return {rounded(z.w, norm), v[0], v[1], v[2]};
}

// Returns true if the leg begins at the body's pose `start`.
bool begins_at_start(const TurnLeg& leg) {
    return leg.from == Quaternion() && leg.pivot == leg.pivot_from;
}

exact::Point point_of(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

// Limits all entries of the pose to 2^1020 in magnitude. Error bounds do not hold above this limit
// (turning_points.hpp); below it, sums can overflow only to infinity.
void clamp(Pose& pose) {
    constexpr double unbounded = 0x1p1020;
    pose.R = pose.R.cwiseMax(-unbounded).cwiseMin(unbounded);
    pose.t = pose.t.cwiseMax(-unbounded).cwiseMin(unbounded);
}

}  // namespace

TurnLeg leg_of(const Pose& start, const Turn& turn, const Vec3& motion) {
    return {start, turn.pivot_from, Quaternion(), turn.q, turn.pivot_from, turn.pivot_to, motion};
}

TurnLeg leg_of(const Pose& start, std::span<const WayNode> nodes, std::size_t leg) {
    const WayNode &from = nodes[leg], &to = nodes[leg + 1];
    return {start, nodes[0].pivot, from.q, to.q, from.pivot, to.pivot};
}

std::size_t last_leg(std::span<const WayNode> nodes) noexcept {
    return nodes.size() - 2;
}

TriangleCorners corners_of(const Mesh& a, std::uint32_t triangle_a, const Mesh& b, std::uint32_t triangle_b) noexcept {
    TriangleCorners corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners.a[i] = &a.vertices()[a.triangles()[triangle_a][i]];
        corners.b[i] = &b.vertices()[b.triangles()[triangle_b][i]];
    }
    return corners;
}

exact::PosedPoints<11> points_of(const TurnLeg& leg, const Pose& b, const TriangleCorners& corners) noexcept {
    static const Pose world;
    static const Vec3 origin = Vec3::Zero();
    exact::PosedPoints<11> points;
    for (std::size_t i = 0; i < 3; ++i) {
        points[i] = {&leg.start, corners.a[i]};
        points[3 + i] = {&b, corners.b[i]};
    }
    points[6] = {&world, &leg.pivot_from};
    points[7] = {&world, &leg.pivot_to};
    points[8] = {&world, &origin};
    points[9] = {&world, &leg.motion};
    points[10] = {&world, &leg.pivot};
    return points;
}

// Returns the pose at time s, less `other`. That pose has the matrix Q(z) R / N and the translation c + s m + Q(z) (t -
// pivot) / N, with z the quaternion at time s, N its norm, R and t the pose at the start, c the pivot's place at time 0
// and m its way.
Pose pose_less(const TurnLeg& leg, double time, const Pose& other) {
    const ScaledInteger s(time);
    const ExactQuaternion z0 = exact_quaternion(leg.from), z1 = exact_quaternion(leg.to),
                          z{part_of_way(z0.w, z1.w, s), part_of_way(z0.v, z1.v, s)};
    const ScaledInteger norm = z.norm();
    Pose result;
    for (int k = 0; k < 3; ++k) {
        const ScaledLongVector turned = z.rotated(exact_vector(leg.start.R.col(k)));
        result.R.col(k) = rounded(minus(turned, times(exact_vector(other.R.col(k)), norm)), norm);
    }
    const ScaledLongVector pivot = part_of_way(exact_vector(leg.pivot_from), exact_vector(leg.pivot_to), s),
                           arm = z.rotated(minus(exact_vector(leg.start.t), exact_vector(leg.pivot)));
    result.t = rounded(plus(arm, times(minus(pivot, exact_vector(other.t)), norm)), norm);
    return result;
}

exact::TurnOfPoints RoundedLeg::turn_of_points(const exact::TurnAngles& angles) const {
    return {pivot, glide, 2 * two_u * exact::largest(pivot) + 0x1p-1000, 2 * two_u * way_size + 0x1p-1000, &angles};
}

RoundedLeg round_beginning(const TurnLeg& leg, const exact::MeshExtent& of_a, const Pose& b) {
    RoundedLeg result;
    result.a = pose_less(leg, 0, {Mat3::Zero(), b.t});
    clamp(result.a);
    result.b = {b.R, Vec3::Zero()};
    const Vec3 size = result.a.R.cwiseAbs() * of_a.magnitude + result.a.t.cwiseAbs();
    result.off = two_u * size.maxCoeff() + 0x1p-1000;
    return result;
}

RoundedLeg round_leg(const TurnLeg& leg, const exact::MeshExtent& of_a, const Pose& b) {
    RoundedLeg result;
    if (begins_at_start(leg)) {
        result.a = leg.start;
        result.b = b;
        result.q = leg.to;
        result.pivot = point_of(leg.pivot_from - leg.start.t);
    } else {
        result = round_beginning(leg, of_a, b);
        result.q = quotient(exact_quaternion(leg.to), exact_quaternion(leg.from));
        const ScaledLongVector pivot = minus(exact_vector(leg.pivot_from), exact_vector(b.t));
        result.pivot = point_of(rounded(minus(pivot, exact_vector(result.a.t)), ScaledInteger(1.0)));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const double way = leg.pivot_to[axis] - leg.pivot_from[axis];
        result.glide[k] = way - leg.motion[axis];
        result.way_size += std::abs(way) + std::abs(leg.motion[axis]);
    }
    return result;
}

}  // namespace ecods
