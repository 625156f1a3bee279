#include "query/cast/settling_motion.hpp"

#include <algorithm>

#include "base/arithmetic.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/point/posed_point.hpp"
#include "query/cast/exact_quaternion.hpp"
#include "query/cast/moving_question.hpp"

namespace ecods {
namespace {

using exact::Integer;
using exact::LongVector3;
using exact::ScaledInteger;
using exact::ScaledLongVector;

// Returns a turn of angle 0, at the end of a leg.
TurnLeg end_of(const TurnLeg& leg) {
    return {leg.start, leg.pivot, leg.to, leg.to, leg.pivot_to, leg.pivot_to};
}

// Returns the quaternion times a power of two that makes all components integers.
ExactQuaternion in_integers(const Quaternion& q) {
    ExactQuaternion z = exact_quaternion(q);
    exact::BitRange digits;
    for (const double x : {q.w, q.x, q.y, q.z}) digits.include(exact::decode(x));
    const auto of = [&](const ScaledInteger& x) { return ScaledInteger(x.in_units(digits.low), 0); };
    return {of(z.w), {of(z.v[0]), of(z.v[1]), of(z.v[2])}};
}

// Returns the corners of both triangles at the start and at the end of the straight motion, times N, the norm of q.
// `points` are a's corners at the start of the way, b's corners, a's corners at the final pose, and the pivot at the
// start of the way and at the end of the leg.
template <class Kernel>
std::array<LongVector3, 12> settling_corners(const exact::IntegerPoints<Kernel, 11>& points, const Quaternion& q) {
    const ExactQuaternion z = in_integers(q);
    const ScaledInteger norm = z.norm();
    const auto at = [&](std::size_t i) -> ScaledLongVector {
        const auto& p = points.at[i];
        return {ScaledInteger(Integer(p[0]), 0), ScaledInteger(Integer(p[1]), 0), ScaledInteger(Integer(p[2]), 0)};
    };
    const auto integers = [](const ScaledLongVector& v) -> LongVector3 {
        return {v[0].in_units(0), v[1].in_units(0), v[2].in_units(0)};
    };
    const ScaledLongVector pivot = times(at(10), norm);
    std::array<LongVector3, 12> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = integers(plus(pivot, z.rotated(minus(at(i), at(9)))));
        corners[3 + i] = corners[9 + i] = integers(times(at(3 + i), norm));
        corners[6 + i] = integers(times(at(6 + i), norm));
    }
    return corners;
}

// Returns true if edge `edge` of triangle `side` crosses the interior of the other triangle at time 0.
bool passes_through(exact::RelativePosition& triangles, std::size_t side, std::size_t edge) {
    const auto of_corner = [&](std::size_t corner) { return triangles.corner_volume(side, corner)[0].sign(); };
    if (of_corner(edge) * of_corner(exact::next_corner(edge)) >= 0) return false;
    int sides = 0;
    for (std::size_t other = 0; other < 3; ++other) {
        sides += (side == 0 ? triangles.edge_volume(edge, other) : triangles.edge_volume(other, edge))[0].sign();
    }
    return sides == 3 || sides == -3;
}

// Returns true if the triangles share a point at time 0. In this case, the relative interiors of a pair of features in
// feature_pairs share a point, or an edge crosses a face.
bool share_point_at_start(exact::RelativePosition& triangles) {
    exact::Root zero{exact::BinaryFraction{}};
    exact::TrianglesAtRoot at_start(triangles, zero);
    for (const exact::FeaturePair& pair : exact::feature_pairs) {
        if (at_start.share_point(pair)) return true;
    }
    for (std::size_t edge = 0; edge < 3; ++edge) {
        if (passes_through(triangles, 0, edge) || passes_through(triangles, 1, edge)) return true;
    }
    return false;
}

}  // namespace

void SettlingMotion::bind(const MeshShape& a, const TurnLeg& leg, const Pose& to, const Posed<MeshShape>& b,
                          CastCounts& counts) {
    a_ = &a;
    leg_ = &leg;
    to_ = &to;
    b_ = &b;
    counts_ = &counts;
    const MeshTree &tree_a = MeshShapeAccess::tree(a), &tree_b = MeshShapeAccess::tree(*b.what);
    trees_ = {TreeAtEnds(tree_a.boxes), TreeAtEnds(tree_b.boxes)};
    end_ = round_beginning(end_of(leg), tree_a.extent, b.pose);
    rounded_to_ = {to.R, to.t - b.pose.t};
    to_off_ = two_u * rounded_to_.t.cwiseAbs().maxCoeff() + 0x1p-1000;
    const std::array<exact::BodyRef, 3> bodies{{{&a.mesh(), &tree_a.extent, &end_.a},
                                                {&b.what->mesh(), &tree_b.extent, &end_.b},
                                                {&a.mesh(), &tree_a.extent, &rounded_to_}}};
    frame_.bind(bodies);
    const MotionMargin margin{.everywhere = 2 * (end_.off + to_off_) * (1 + 16 * two_u)};
    axes_.bind({trees_[0], end_.a.R, rounded_to_.R}, {trees_[1], b.pose.R, b.pose.R}, -end_.a.t, -rounded_to_.t,
               margin);
    known_.clear();
}

exact::MovingPoints SettlingMotion::points_of(const TrianglePair& triangles) {
    const Triangle &of_a = mesh(0).triangles()[triangles.a], &of_b = mesh(1).triangles()[triangles.b];
    exact::MovingPoints points;
    points.start = frame_.rounded(exact::corners_of(of_a, of_b));
    points.end = points.start;
    for (std::size_t i = 0; i < 3; ++i) points.end[i] = frame_.rounded(2, of_a[i]);
    points.start_error = std::max(frame_.delta(0) + end_.off, frame_.delta(1)) * (1 + 2 * two_u);
    points.end_error = std::max(frame_.delta(2) + to_off_, frame_.delta(1)) * (1 + 2 * two_u);
    return points;
}

std::optional<exact::TimeSpan> SettlingMotion::bound(const TrianglePair& triangles, double from, double to,
                                                     exact::Effort effort) {
    ++counts_->enclosures;
    return exact::bound_first_meeting(points_of(triangles), from, to, effort);
}

template <class Function>
auto SettlingMotion::ask_exactly(const TrianglePair& triangles, Function&& ask) {
    ++counts_->exact;
    static const Pose world;
    const TriangleCorners corners = ecods::corners_of(mesh(0), triangles.a, mesh(1), triangles.b);
    exact::PosedPoints<11> points;
    for (std::size_t i = 0; i < 3; ++i) {
        points[i] = {&leg_->start, corners.a[i]};
        points[3 + i] = {&b_->pose, corners.b[i]};
        points[6 + i] = {to_, corners.a[i]};
    }
    points[9] = {&world, &leg_->pivot};
    points[10] = {&world, &leg_->pivot_to};
    const auto scaled =
        exact::with_integers(points, [&](const auto& integers) { return settling_corners(integers, leg_->to); });
    exact::MovingTriangles moving(scaled);
    return ask(moving);
}

std::optional<exact::Meeting> SettlingMotion::decide(const TrianglePair& triangles, exact::TimeSpan time, double to) {
    const bool may_meet_at_start = key_of(time.from) == 0;
    if (may_meet_at_start &&
        ask_exactly(triangles, [](exact::RelativePosition& at) { return share_point_at_start(at); }))
        return exact::Meeting{0, false, exact::feature_pairs[0]};
    return MeetingDecision(*this, known_, triangles).decide(time, to);
}

}  // namespace ecods
