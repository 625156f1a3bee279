#include "query/body/sliding_edges.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "exact/measure/round/long_rounding.hpp"
#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"
#include "exact/simplex/common_pose.hpp"

namespace ecods {
namespace {

using exact::ScaledInteger;
using exact::ScaledLongVector;

// A Time is num / den, with den > 0.
struct Time {
    ScaledInteger num{0.0}, den{1.0};

    friend int compare(const Time& x, const Time& y) { return compare(x.num * y.den, y.num * x.den); }
};

struct Extent {
    ScaledInteger least, greatest;

    Extent(const ScaledLongVector& axis, std::span<const ScaledLongVector> points) {
        least = greatest = dot(axis, points[0]);
        for (const ScaledLongVector& point : points.subspan(1)) {
            const ScaledInteger x = dot(axis, point);
            if (compare(x, least) < 0) least = x;
            if (compare(x, greatest) > 0) greatest = x;
        }
    }
};

// An InPlane is a segment that is translated by s times the motion, and a triangle, all in one plane with the normal n.
struct InPlane {
    std::array<ScaledLongVector, 2> segment;
    std::array<ScaledLongVector, 3> triangle;
    ScaledLongVector motion, n;

    bool overlaps_along_motion() const {
        const ScaledLongVector across = cross(n, motion);
        const Extent s(across, segment), t(across, triangle);
        return compare(s.least, t.greatest) < 0 && compare(t.least, s.greatest) < 0;
    }

    // Returns the first time from 0 on at which no line in the plane separates segment and triangle, if it is less than
    // `end`; otherwise nullopt. All such times form an interval.
    std::optional<double> first_time(const ScaledInteger& end) const {
        std::vector<ScaledLongVector> sides{minus(segment[1], segment[0])};
        for (std::size_t i = 0; i < 3; ++i) sides.push_back(minus(triangle[(i + 1) % 3], triangle[i]));
        std::optional<Time> first, last;
        for (const ScaledLongVector& side : sides) {
            const ScaledLongVector axis = cross(n, side);
            const Extent s(axis, segment), t(axis, triangle);
            ScaledInteger low = t.least - s.greatest, high = t.greatest - s.least, speed = dot(axis, motion);
            if (speed.sign() == 0) {
                if (low.sign() > 0 || high.sign() < 0) return std::nullopt;
                continue;
            }
            if (speed.sign() < 0) {
                std::swap(low, high);
                low = -low, high = -high, speed = -speed;
            }
            const Time from{low, speed}, to{high, speed};
            if (!first || compare(*first, from) < 0) first = from;
            if (!last || compare(to, *last) < 0) last = to;
        }
        if (!first || compare(*last, *first) < 0 || last->num.sign() <= 0) return std::nullopt;
        if (first->num.sign() < 0) first->num = ScaledInteger();
        if (compare(first->num, end * first->den) >= 0) return std::nullopt;
        if (first->num.sign() == 0) return 0;
        return exact::round_quotient(first->num, first->den);
    }
};

}  // namespace

SlidingSolids::SlidingSolids(const Posed<Solid>& a, const Vec3& motion, const Posed<Solid>& b)
    : bodies_{body_of(a), body_of(b)}, motion_(exact::exact_vector(motion)) {}

SlidingSolids::Body SlidingSolids::body_of(const Posed<Solid>& posed) {
    return {posed.what, &SolidAccess::parts(*posed.what), &SolidAccess::shells(*posed.what), posed.pose,
            exact::is_mirror(posed.pose.R)};
}

Posed<MeshShape> SlidingSolids::mesh(std::size_t side) const {
    const Body& body = bodies_[side];
    return {body.parts->split_shape != nullptr ? *body.parts->split_shape : *body.solid, body.pose};
}

std::uint32_t SlidingSolids::name(std::size_t side, std::uint32_t triangle) const {
    const auto& origins = bodies_[side].parts->origins;
    return origins.empty() ? triangle : origins[triangle].triangle;
}

bool SlidingSolids::counts(std::size_t side, std::uint32_t triangle) const {
    return bodies_[side].parts->proper.is_proper(triangle);
}

ScaledLongVector SlidingSolids::Body::point(std::uint32_t vertex) const {
    return exact::posed_point(pose, mesh().vertices()[vertex]);
}

std::array<ScaledLongVector, 3> SlidingSolids::Body::corners(std::uint32_t triangle) const {
    const Triangle& t = mesh().triangles()[triangle];
    return {point(t[0]), point(t[1]), point(t[2])};
}

ScaledLongVector SlidingSolids::Body::outer_normal(std::uint32_t triangle) const {
    const auto [p, q, r] = corners(triangle);
    const bool faces_in = (shells->faces_in[triangle] != 0) != is_mirrored;
    return faces_in ? cross(minus(r, p), minus(q, p)) : cross(minus(q, p), minus(r, p));
}

bool SlidingSolids::reaches_below(const Body& body, const SideRef& edge, const ScaledLongVector& n) const {
    struct HalfPlane {
        ScaledLongVector way, outer;  // from the edge to the triangle's third corner; the triangle's outer normal
    };
    const std::span<const Triangle> triangles = body.mesh().triangles();
    std::vector<HalfPlane> around;
    for (const SideRef& side : body.parts->edges.sides(body.parts->edges.edge_of(edge))) {
        const auto [from, to, apex] = corners_from(triangles, side);
        around.push_back({minus(body.point(apex), body.point(from)), body.outer_normal(side.triangle)});
    }
    const auto height = [&](const HalfPlane& half) { return dot(n, half.way).sign(); };
    if (std::ranges::any_of(around, [&](const HalfPlane& half) { return height(half) < 0; })) return true;
    for (const HalfPlane& half : around) {
        if (height(half) == 0) return dot(half.outer, n).sign() > 0;
    }
    for (const HalfPlane& half : around) {
        int outside = 0, inside = 0;
        for (const HalfPlane& other : around) {
            const int sign = dot(half.outer, other.way).sign();
            outside += sign > 0;
            inside += sign < 0;
        }
        if (outside == 0 || inside == 0) return inside == 0;
    }
    return false;  // not reached: of half-planes within half a turn, two have all others on one side
}

std::optional<double> SlidingSolids::time(std::size_t side, std::uint32_t triangle, std::uint32_t corner,
                                          std::uint32_t face, double end) {
    const Body &moving = bodies_[side], &other = bodies_[1 - side];
    const ScaledLongVector n = other.outer_normal(face);
    const auto corners = moving.corners(triangle);
    InPlane plane{{corners[corner], corners[(corner + 1) % 3]}, other.corners(face), motion_, n};
    if (side == 1) {
        for (ScaledInteger& x : plane.motion) x = -x;
    }
    if (!plane.overlaps_along_motion()) return std::nullopt;
    const auto time = plane.first_time(ScaledInteger(end));
    if (!time || !reaches_below(moving, {triangle, corner}, n)) return std::nullopt;
    return time;
}

}  // namespace ecods
