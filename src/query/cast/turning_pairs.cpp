#include "query/cast/turning_pairs.hpp"

#include <algorithm>

#include "base/arithmetic.hpp"
#include "query/cast/turn_vector.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

void TurningPairs::bind(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                        CastCounts& counts) {
    a_ = &a;
    b_ = &b;
    motion_ = &motion;
    way_size_ = 0;
    counts_ = &counts;
    const std::array<exact::BodyRef, 2> bodies{{{&a.what->mesh(), &MeshShapeAccess::tree(*a.what).extent, &a.pose},
                                                {&b.what->mesh(), &MeshShapeAccess::tree(*b.what).extent, &b.pose}}};
    frame_.bind(bodies);
    angles_ = exact::TurnAngles(a.turn.q.w, vector_of(a.turn.q));
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        pivot_[k] = a.turn.pivot_from[axis] - a.pose.t[axis];
        const double way = a.turn.pivot_to[axis] - a.turn.pivot_from[axis];
        glide_[k] = way - motion[axis];
        way_size_ += std::abs(way) + std::abs(motion[axis]);
    }
    integers_.reset();
    known_.clear();
}

std::array<exact::VertexRef, 6> TurningPairs::corners_of(const TrianglePair& triangles) const {
    return exact::corners_of(mesh(0).triangles()[triangles.a], mesh(1).triangles()[triangles.b]);
}

exact::TurningPoints TurningPairs::points_of(const TrianglePair& triangles) {
    const double pivot_error = 2 * two_u * exact::largest(pivot_) + 0x1p-1000;
    return {frame_.rounded(corners_of(triangles)),
            std::max(frame_.delta(0), frame_.delta(1)),
            {pivot_, glide_, pivot_error, 2 * two_u * way_size_ + 0x1p-1000, &angles_}};
}

std::optional<exact::TimeSpan> TurningPairs::bound(const TrianglePair& triangles, double from, double to,
                                                   exact::Effort effort) {
    if (const auto* whole = known_.find_whole(triangles)) return KnownMeetings::span_of(*whole, from, to);
    ++counts_->enclosures;
    return exact::bound_first_meeting(points_of(triangles), from, to, effort);
}

template <class Function>
auto TurningPairs::ask_exactly(const TrianglePair& triangles, Function&& ask) {
    ++counts_->exact;
    if (!integers_) integers_.emplace(a_->turn.q.w, vector_of(a_->turn.q));
    static const Pose world;
    const Vec3 origin = Vec3::Zero();
    exact::PosedPoints<10> points;
    std::ranges::copy(frame_.posed(corners_of(triangles)), points.begin());
    points[6] = {&world, &a_->turn.pivot_from};
    points[7] = {&world, &a_->turn.pivot_to};
    points[8] = {&world, &origin};
    points[9] = {&world, motion_};
    return exact::with_integers(points, [&](const auto& integers) {
        exact::TurningTriangles turning(integers, *integers_);
        return ask(turning);
    });
}

std::optional<exact::Meeting> TurningPairs::decide(const TrianglePair& triangles, exact::TimeSpan time, double to) {
    return MeetingDecision(*this, known_, triangles).decide(time, to);
}

}  // namespace ecods
