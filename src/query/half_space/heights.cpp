#include "query/half_space/heights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "ecods/error.hpp"
#include "ecods/primitives.hpp"
#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::half_spaces {
namespace {

using exact::ScaledInteger;
using ExactVector = exact::ScaledLongVector;

constexpr double size_max = 0x1p100;
constexpr double underflow = 0x1p-600;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Returns x, or -x if the sign is negative.
ScaledInteger turned(const ScaledInteger& x, int sign) {
    return sign < 0 ? -x : x;
}

// Returns, for each coordinate of a x b, the sum of the magnitudes of its two products.
Vec3 cross_size(const Vec3& a, const Vec3& b) {
    const Vec3 x = a.cwiseAbs(), y = b.cwiseAbs();
    return {x[1] * y[2] + x[2] * y[1], x[2] * y[0] + x[0] * y[2], x[0] * y[1] + x[1] * y[0]};
}

double dot(const Vec3& a, const Vec3& b) {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

// Returns true if no coordinate's magnitude exceeds 2^100; false if a coordinate is NaN.
bool is_moderate(const Vec3& v) {
    return std::abs(v[0]) <= size_max && std::abs(v[1]) <= size_max && std::abs(v[2]) <= size_max;
}

bool is_moderate(const Pose& pose) {
    return is_moderate(pose.R.col(0)) && is_moderate(pose.R.col(1)) && is_moderate(pose.R.col(2)) &&
           is_moderate(pose.t);
}

int orientation_of(const Mat3& R, int argument) {
    const Sign sign = orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2));
    if (sign == Sign::zero) throw SingularPose(argument);
    return sign == Sign::positive ? 1 : -1;
}

}  // namespace

Plane::Plane(const Posed<HalfSpace>& posed, int argument)
    : half_space_(*posed.what), pose_(posed.pose), orientation_(orientation_of(posed.pose.R, argument)) {
    const Vec3& n = half_space_.normal();
    const Vec3 r[3] = {pose_.R.col(0), pose_.R.col(1), pose_.R.col(2)};
    const Vec3 C[3] = {r[1].cross(r[2]), r[2].cross(r[0]), r[0].cross(r[1])};
    const Vec3 C_size[3] = {cross_size(r[1], r[2]), cross_size(r[2], r[0]), cross_size(r[0], r[1])};
    const double s = orientation_, d = half_space_.offset();
    N_ = s * ((C[0] * n[0] + C[1] * n[1]) + C[2] * n[2]);
    N_size_ = (C_size[0] * std::abs(n[0]) + C_size[1] * std::abs(n[1])) + C_size[2] * std::abs(n[2]);
    E_ = s * (dot(r[0], C[0]) * d);
    E_size_ = dot(r[0].cwiseAbs(), C_size[0]) * std::abs(d);
    is_moderate_ = is_moderate(pose_) && is_moderate(n) && std::abs(d) <= size_max;
}

const Plane::Exact& Plane::exact() const {
    if (exact_) return *exact_;
    const ExactVector r[3] = {exact::exact_vector(pose_.R.col(0)), exact::exact_vector(pose_.R.col(1)),
                              exact::exact_vector(pose_.R.col(2))};
    const ExactVector C[3] = {cross(r[1], r[2]), cross(r[2], r[0]), cross(r[0], r[1])};
    const ExactVector n = exact::exact_vector(half_space_.normal());
    Exact result;
    for (std::size_t k = 0; k < 3; ++k) result.N[k] = turned(dot({C[0][k], C[1][k], C[2][k]}, n), orientation_);
    result.E = turned(dot(r[0], C[0]) * ScaledInteger(half_space_.offset()), orientation_);
    result.square = dot(result.N, result.N);
    return exact_.emplace(std::move(result));
}

ScaledInteger Plane::along(const Vec3& vector) const {
    return dot(exact().N, exact::exact_vector(vector));
}

HeightBounds Plane::times_length(double d) const noexcept {
    if (!is_moderate_ || !(d <= size_max)) return {-infinity, infinity};
    const double length = std::sqrt(dot(N_, N_)), size = std::sqrt(dot(N_size_, N_size_));
    const double error = 8 * two_u * (length + size) * d + (0x1p-509 * d + underflow);
    return {length * d - error, length * d + error};
}

ScaledInteger Plane::height(const Vec3& point) const {
    return along(point) - along(pose_.t) - exact().E;
}

Heights::Heights(const Plane& plane, const Pose& body, Side side)
    : plane_(plane), body_(body), side_(static_cast<double>(side)) {
    const Mat3& R = body.R;
    const Vec3 N = side_ * plane.N_, &size = plane.N_size_, offset = body.t - plane.pose_.t;
    for (int k = 0; k < 3; ++k) {
        M_[k] = dot(N, R.col(k));
        M_size_[k] = dot(size, R.col(k).cwiseAbs());
    }
    c_ = dot(N, offset) - side_ * plane.E_;
    c_size_ = dot(size, offset.cwiseAbs()) + plane.E_size_;
    is_moderate_ = plane.is_moderate_ && is_moderate(body);
}

HeightBounds Heights::bounds(const Vec3& v) const noexcept {
    if (!is_moderate_ || !is_moderate(v)) return {-infinity, infinity};
    const double h = dot(M_, v) + c_;
    const double error = 16 * two_u * (dot(M_size_, v.cwiseAbs()) + c_size_) + underflow;
    return {h - error, h + error};
}

ScaledInteger Heights::exact(const Vec3& v) const {
    if (!exact_) {
        Exact result;
        const int side = side_ < 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k) {
            result.M[static_cast<std::size_t>(k)] = turned(plane_.along(Vec3(body_.R.col(k))), side);
        }
        result.c = turned(plane_.height(body_.t), side);
        exact_.emplace(std::move(result));
    }
    return dot(exact_->M, exact::exact_vector(v)) + exact_->c;
}

int Heights::sign(const Vec3& v) const {
    const HeightBounds h = bounds(v);
    if (h.low > 0) return 1;
    if (h.high < 0) return -1;
    return exact(v).sign();
}

BoxHeights::BoxHeights(const Heights& heights, const MeshBvh& tree) noexcept : tree_(tree) {
    const LocalFrame& frame = tree.frame;
    double size = dot(heights.M_size_, frame.center.cwiseAbs()) + heights.c_size_;
    q_ = dot(heights.M_, frame.center) + heights.c_;
    for (int k = 0; k < 3; ++k) {
        const Vec3 column = frame.map.col(k);
        const auto at = static_cast<std::size_t>(k);
        P_[at] = dot(heights.M_, column);
        P_size_[at] = std::abs(P_[at]);
        size += 2 * dot(heights.M_size_, column.cwiseAbs());
    }
    const bool is_usable = heights.is_moderate_ && frame.is_bounded && frame.size_max <= size_max;
    margin_ = is_usable ? 24 * two_u * size + underflow : infinity;
    corner_margin_ = margin_ + 1.01 * corner_error * ((P_size_[0] + P_size_[1]) + P_size_[2]);
}

// The comparison is negated so that it keeps a lane whose bound is NaN.
std::uint32_t BoxHeights::lanes_below(const BvhNode& node, double limit) const noexcept {
    std::uint32_t lanes = 0;
    for (std::size_t i = 0; i < tree_width; ++i) {
        const double low = below(node.center[0][i], node.center[1][i], node.center[2][i], node.half[0][i],
                                 node.half[1][i], node.half[2][i]);
        lanes |= static_cast<std::uint32_t>(!(low > limit)) << i;
    }
    return lanes & node.lanes();
}

std::uint32_t BoxHeights::lanes_below(const TreeLeaf& leaf, double limit) const noexcept {
    std::uint32_t lanes = 0;
    for (const auto& corner : leaf.corner) {
        for (std::size_t i = 0; i < tree_width; ++i) {
            const double x = corner[0][i], y = corner[1][i], z = corner[2][i];
            const double low = (((P_[0] * x + P_[1] * y) + P_[2] * z) + q_) - corner_margin_;
            lanes |= static_cast<std::uint32_t>(!(low > limit)) << i;
        }
    }
    return lanes & leaf.lanes();
}

}  // namespace ecods::half_spaces
