#include "query/cast/turn_and_straight_pairs.hpp"

#include <algorithm>

#include "base/arithmetic.hpp"
#include "exact/measure/contact/both_turning_triangles.hpp"
#include "query/cast/turn_vector.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

void TurnAndStraightPairs::bind(const Turning<MeshShape>& a, const Moving<MeshShape>& b, CastCounts& counts) {
    a_ = &a;
    b_ = &b;
    bind_counts(counts);
    const exact::MeshExtent &extent_a = MeshShapeAccess::tree(*a.what).extent,
                            &extent_b = MeshShapeAccess::tree(*b.what).extent;
    const std::array<exact::BodyRef, 3> bodies{{{&a.what->mesh(), &extent_a, &a.pose},
                                                {&b.what->mesh(), &extent_b, &b.from},
                                                {&b.what->mesh(), &extent_b, &b.to}}};
    frame_.bind(bodies);
    rounded_ = round_leg(leg_of(a.pose, a.turn), extent_a, b.from);
    angles_ = exact::TurnAngles(a.turn.q.w, vector_of(a.turn.q));
    integers_.reset();
}

exact::TurnAndStraightPoints TurnAndStraightPairs::points_of(const TrianglePair& triangles) {
    const Triangle &of_a = mesh(0).triangles()[triangles.a], &of_b = mesh(1).triangles()[triangles.b];
    exact::TurnAndStraightPoints points{frame_.rounded(exact::corners_of(of_a, of_b)),
                                        std::max(frame_.delta(0), frame_.delta(1)),
                                        rounded_.turn_of_points(angles_),
                                        {},
                                        frame_.delta(2)};
    for (std::size_t i = 0; i < 3; ++i) points.end[i] = frame_.rounded(2, of_b[i]);
    return points;
}

template <class Function>
auto TurnAndStraightPairs::ask_exactly(const TrianglePair& triangles, Function&& ask) {
    ++counts_->exact;
    if (!integers_) integers_.emplace(a_->turn.q.w, vector_of(a_->turn.q));
    static const Pose world;
    const TriangleCorners corners = ecods::corners_of(mesh(0), triangles.a, mesh(1), triangles.b);
    exact::PosedPoints<11> points;
    for (std::size_t i = 0; i < 3; ++i) {
        points[i] = {&a_->pose, corners.a[i]};
        points[3 + i] = {&b_->from, corners.b[i]};
        points[6 + i] = {&b_->to, corners.b[i]};
    }
    points[9] = {&world, &a_->turn.pivot_from};
    points[10] = {&world, &a_->turn.pivot_to};
    return exact::with_integers(points, [&](const auto& integers) {
        exact::BothTurningTriangles moving(integers, *integers_);
        return ask(moving);
    });
}

std::optional<exact::Meeting> TurnAndStraightPairs::decide(const TrianglePair& triangles, exact::TimeSpan time,
                                                           double to) {
    return MeetingDecision(*this, known_, triangles).decide(time, to);
}

}  // namespace ecods
