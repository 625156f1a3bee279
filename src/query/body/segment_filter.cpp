// This file bounds the distance of two segments from above and below, in doubles. Let u' = two_u, and let p0, p1 and
// q0, q1 be the rounded ends of the first and the second segment. Each coordinate of an end is off by at most delta. M
// bounds the magnitudes of all coordinates.
//
// Upper bound. For any s and t in [0, 1], the distance of the points p0 + s (p1 - p0) and q0 + t (q1 - q0) is an upper
// bound of the distance of the segments. A coordinate of one of these points is computed with a difference below 2 M, a
// product and a sum, so it is off by at most u' (2 M + 2 M + 3 M) (1 + u')^2 < 8 u' M; the difference z of the two has
// one more rounding, of at most 2.1 M, and both true ends are off by delta: E = 2 delta + 20 u' M bounds the error of a
// coordinate of z, and sqrt(3) E that of |z|. |z| is computed with a relative error of less than 4 u'.
//
// Lower bound. For any vector n, here z, the distance is at least (min n.q - max n.p) / |n| (weak duality). A product
// n.q as computed is off by at most ((1 + u')^3 - 1) M |n|_1 and delta |n|_1, and the difference of two products by 2.1
// u' M |n|_1 more: E |n|_1 covers both products and the difference. Factors of 1 +- 8 u' cover the roundings of |n|_1,
// |n| and the quotients.
//
// The sum of three numbers is off by less than 3 u' of itself. Underflow: if M and the sum are at most 2^400, and the
// compared numbers are at least 2^-400, underflow loses numbers below 2^-900, which are added to others of at least
// 2^-500.
// Claim: verify/proofs/root_sums.py
#include "query/body/segment_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/arithmetic.hpp"
#include "base/outward.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {
namespace {

using exact::dot;
using exact::minus;
using exact::Point;

constexpr double root_of_3 = 1.7320509, least = 0x1p-400, most = 0x1p400;

// A RoundedSegment holds the ends of a segment relative to an origin, rounded, and a bound of their errors.
struct RoundedSegment {
    RoundedSegment(const Posed<MeshShape>& body, const Vec3& origin) noexcept {
        const Pose& pose = body.pose;
        const Vec3 offset = pose.t - origin;
        const Triangle& corners = body.what->mesh().triangles()[0];
        const auto vertices = body.what->mesh().vertices();
        const Vec3 &p = vertices[corners[0]], &q = vertices[corners[1]];
        is_point = corners[1] == corners[0];
        if (is_point && is_zero(p)) {
            delta = exact::point_error_bound(offset.cwiseAbs().maxCoeff(), 0);
            end[0] = end[1] = {offset[0], offset[1], offset[2]};
            return;
        }
        delta = exact::point_error_bound(pose.R, p.cwiseAbs().cwiseMax(q.cwiseAbs()), offset);
        end[0] = exact::pose_point(pose.R, p, offset);
        end[1] = is_point ? end[0] : exact::pose_point(pose.R, q, offset);
    }

    std::array<Point, 2> end;
    double delta = 0;
    bool is_point;
};

double from_0_to_1(double x) noexcept {
    return std::min(1.0, std::max(0.0, x));  // 0 for NaN
}

Point point_at(const RoundedSegment& segment, double s) noexcept {
    Point x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = segment.end[0][k] + s * (segment.end[1][k] - segment.end[0][k]);
    return x;
}

// Returns the parameter of the segment's point that is approximately closest to the other end of w, which begins at the
// segment's first end.
double nearest_on(const RoundedSegment& segment, const Point& w) noexcept {
    const Point u = minus(segment.end[1], segment.end[0]);
    return from_0_to_1(dot(u, w) / dot(u, u));
}

// Returns the difference of two points of the segments that are approximately closest to each other.
Point between(const RoundedSegment& a, const RoundedSegment& b) noexcept {
    const Point w = minus(b.end[0], a.end[0]);
    if (a.is_point && b.is_point) return w;
    if (a.is_point) return minus(point_at(b, nearest_on(b, exact::negated(w))), a.end[0]);
    if (b.is_point) return minus(b.end[0], point_at(a, nearest_on(a, w)));
    const Point u = minus(a.end[1], a.end[0]), v = minus(b.end[1], b.end[0]);
    const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
    double s = from_0_to_1((uw * vv - uv * vw) / (uu * vv - uv * uv));
    const double t = from_0_to_1((s * uv - vw) / vv);
    s = from_0_to_1((t * uv + uw) / uu);
    return minus(point_at(b, t), point_at(a, s));
}

}  // namespace

bool is_segment(const MeshShape& shape) noexcept {
    if (shape.mesh().triangles().size() != 1) return false;
    const Triangle& corners = shape.mesh().triangles()[0];
    return corners[1] == corners[2];
}

std::optional<int> compare_segments(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double x, double y,
                                    double z) noexcept {
    const RoundedSegment p(a, a.pose.t), q(b, a.pose.t);
    const double size = std::max(std::max(exact::largest(p.end[0]), exact::largest(p.end[1])),
                                 std::max(exact::largest(q.end[0]), exact::largest(q.end[1])));
    const double sum = (x + y) + z;
    if (!(size <= most && sum <= most && sum >= least)) return std::nullopt;
    const Point n = between(p, q);
    const double error = 2 * std::max(p.delta, q.delta) + 20 * two_u * size;
    const double length = std::sqrt(dot(n, n));
    if ((length * (1 + 8 * two_u) + root_of_3 * error) * (1 + 8 * two_u) < sum * (1 - 8 * two_u)) return -1;
    if (!(length >= least)) return std::nullopt;
    const double gap = std::min(dot(n, q.end[0]), dot(n, q.end[1])) - std::max(dot(n, p.end[0]), dot(n, p.end[1]));
    const double certain = gap - error * exact::sum_of_magnitudes(n) * (1 + 8 * two_u);
    if (certain * (1 - 8 * two_u) > sum * (length * (1 + 8 * two_u)) * (1 + 8 * two_u)) return 1;
    return std::nullopt;
}

}  // namespace ecods
