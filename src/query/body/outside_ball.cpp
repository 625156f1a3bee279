#include "query/body/outside_ball.hpp"

#include <cmath>

#include "base/arithmetic.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {
namespace {

// Returns an upper bound of the distance of the vertex from the center.
//
// Derivation, with u' = two_u. A difference is computed with a relative error of u', and the vertex is off by at most
// `error` on each axis: |difference| (1 + 2 u') + error, but for two roundings, is an upper bound of the true
// difference. So a square is low by five roundings, the sum of three by seven, the root by half of that and one, and
// the last product by one more: a factor of less than (1 - u')^-6 < 1 + 16 u'. Underflow loses at most 2^-1022 in each
// square, less than 2^-510 in the root, which the added 2^-509 covers.
// Claim: verify/proofs/small_bounds.py
double reach_of(const RoundedVertex& vertex, const exact::Point& center) noexcept {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double gap = std::abs(vertex.point[axis] - center[axis]) * (1 + 2 * two_u) + vertex.error;
        sum += gap * gap;
    }
    return std::sqrt(sum) * (1 + 16 * two_u) + 0x1p-509;
}

}  // namespace

bool OutsideBall::contains(const RoundedVertex& vertex) noexcept {
    const bool is_inside = reach_of(vertex, center_) < radius_;
    held_count_ += is_inside;
    return is_inside;
}

// The ball is around the rounded vertex. It contains the vertex itself, which is outside, so the whole ball is outside.
void OutsideBall::find_around(const RoundedVertex& vertex) {
    if (ball_count_ > held_count_ + spare_count) return;
    ++ball_count_;
    radius_ = 0;
    center_ = vertex.point;
    const Vec3 center(center_[0], center_[1], center_[2]);
    if (!center.allFinite()) return;
    const Posed<MeshShape> point(point_shape(), Pose{Mat3::Identity(), center});
    const DistanceTolerance half{.relative = 0.5};
    const double lower =
        as_part(memory_, [&] { return surface::distance_bounds(point, boundary_, half, memory_); }).lower;
    if (lower >= 0x1p-500 && reach_of(vertex, center_) < lower) radius_ = lower;
}

}  // namespace ecods
