// This file computes poses of bodies that turn, in integers and rounded once, and the turn between two poses, in
// doubles.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "base/arithmetic.hpp"
#include "base/limits.hpp"
#include "exact/point/point.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/used_vertices.hpp"
#include "query/cast/turn_leg.hpp"

namespace ecods {
namespace {

const Pose no_pose{Mat3::Zero(), Vec3::Zero()};

// Returns the matrix K of between(). Both matrices are scaled first, so that products neither overflow nor underflow.
std::array<std::array<double, 3>, 3> rotation_between(const Mat3& from, const Mat3& to) {
    const double size_from = from.cwiseAbs().maxCoeff(), size_to = to.cwiseAbs().maxCoeff();
    std::array<std::array<double, 3>, 3> K;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const auto term = [&](int k) { return (to(i, k) / size_to) * (from(j, k) / size_from); };
            const double entry = (term(0) + term(1)) + term(2);
            K[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = entry;
            sum += entry * entry;
        }
    }
    const double length = std::sqrt(sum / 3);
    for (auto& row : K) {
        for (double& entry : row) entry /= length;
    }
    return K;
}

}  // namespace

Pose pose_at(const Pose& pose, const Turn& turn, double time) {
    validate(pose);
    validate(turn);
    if (!is_from_zero(time) || key_of(time) > key_of(1.0)) throw invalid_time(time);
    return pose_less(leg_of(pose, turn), time, no_pose);
}

// Returns an upper bound of the distance |D v + d| of the two places of a vertex v, where D and d are the difference of
// the poses. Each entry of D and d is rounded once, and products and sums as computed are off by less than 5 u' of the
// sum of magnitudes.
// Claim: verify/proofs/turn_pieces.md
double end_gap(const MeshShape& shape, const Pose& from, const Turn& turn, const Pose& to) {
    validate(from);
    validate(turn);
    validate(to);
    const Pose difference = pose_less(leg_of(from, turn), 1, to);
    const Mat3 size = difference.R.cwiseAbs();
    if (difference == no_pose) return 0;
    double most = 0;
    for_each_used_vertex(shape.mesh(), [&](std::uint32_t index) {
        const Vec3& v = shape.mesh().vertices()[index];
        const Vec3 gap = difference.R * v + difference.t;
        const Vec3 off = 8 * two_u * (size * v.cwiseAbs() + difference.t.cwiseAbs());
        const Vec3 above = gap.cwiseAbs() + off;
        // Takes the sum of the coordinates, which is an upper bound of the length, too, if squares may overflow.
        const double sum = above.sum(), length = sum < 0x1p500 ? std::sqrt(above.squaredNorm()) : sum;
        if (!(length <= most)) most = length;
    });
    // A sum that overflows is above this limit in every rounding mode.
    return most < 0x1p1000 ? most * (1 + 8 * two_u) + 0x1p-500 : std::numeric_limits<double>::infinity();
}

// Returns the turn from pose 0 to pose 1, with the matrices R0 and R1. Let K be R1 R0^T, divided by the root of a third
// of its sum of squares: if the poses differ by a rotation, K is that rotation. The quaternion of K is computed by
// Shepperd's method (Quaternion from rotation matrix, 1978): the largest of the four components comes first.
Turn between(const Pose& from, const Pose& to, const Vec3& pivot_in_body) {
    validate(from);
    validate(to);
    for (int k = 0; k < 3; ++k) {
        if (!is_finite(pivot_in_body[k])) throw invalid_turn("pivot(" + std::to_string(k) + ")", pivot_in_body[k]);
    }
    const std::array<std::array<double, 3>, 3> K = rotation_between(from.R, to.R);
    const double det = exact::dot(K[0], exact::cross(K[1], K[2]));
    if (!(det > 0.5)) throw no_rotation_between();
    const double trace = (K[0][0] + K[1][1]) + K[2][2];
    const std::array<double, 4> squares{1 + trace, 1 + (K[0][0] - K[1][1] - K[2][2]), 1 + (K[1][1] - K[2][2] - K[0][0]),
                                        1 + (K[2][2] - K[0][0] - K[1][1])};
    const auto first = static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
    const double twice = std::sqrt(squares[first]), over = 0.5 / twice;
    std::array<double, 4> q{0.5 * twice, (K[2][1] - K[1][2]) * over, (K[0][2] - K[2][0]) * over,
                            (K[1][0] - K[0][1]) * over};
    if (first != 0) {
        const std::size_t i = first - 1;
        q[0] = q[first];
        q[first] = 0.5 * twice;
        for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3}) q[1 + j] = (K[i][j] + K[j][i]) * over;
        if (q[0] < 0) q = {-q[0], -q[1], -q[2], -q[3]};
    }
    const auto place = [&](const Pose& pose) -> Vec3 {
        const exact::Point p = exact::pose_point(pose.R, pivot_in_body, pose.t);
        return {p[0], p[1], p[2]};
    };
    const Turn turn{{q[0], q[1], q[2], q[3]}, place(from), place(to)};
    validate(turn);
    return turn;
}

}  // namespace ecods
