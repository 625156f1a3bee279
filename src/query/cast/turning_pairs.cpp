#include "query/cast/turning_pairs.hpp"

#include <algorithm>

#include "base/arithmetic.hpp"
#include "query/cast/turn_vector.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

void TurningPairs::bind(const MeshShape& a, const TurnLeg& leg, const Posed<MeshShape>& b, CastCounts& counts) {
    a_ = &a;
    leg_ = &leg;
    b_ = &b;
    bind_counts(counts);
    const exact::MeshExtent &extent_a = MeshShapeAccess::tree(a).extent,
                            &extent_b = MeshShapeAccess::tree(*b.what).extent;
    rounded_ = round_leg(leg, extent_a, b.pose);
    const std::array<exact::BodyRef, 2> bodies{
        {{&a.mesh(), &extent_a, &rounded_.a}, {&b.what->mesh(), &extent_b, &rounded_.b}}};
    frame_.bind(bodies);
    angles_ = exact::TurnAngles(rounded_.q.w, {rounded_.q.x, rounded_.q.y, rounded_.q.z});
    integers_.reset();
}

std::array<exact::VertexRef, 6> TurningPairs::corners_of(const TrianglePair& triangles) const {
    return exact::corners_of(mesh(0).triangles()[triangles.a], mesh(1).triangles()[triangles.b]);
}

exact::TurningPoints TurningPairs::points_of(const TrianglePair& triangles) {
    return {frame_.rounded(corners_of(triangles)),
            std::max(frame_.delta(0) + rounded_.off, frame_.delta(1)) * (1 + 2 * two_u),
            rounded_.turn_of_points(angles_)};
}

template <class Function>
auto TurningPairs::ask_exactly(const TrianglePair& triangles, Function&& ask) {
    ++counts_->exact;
    if (!integers_) integers_.emplace(leg_->from, leg_->to);
    const exact::PosedPoints<11> points =
        ecods::points_of(*leg_, b_->pose, ecods::corners_of(mesh(0), triangles.a, mesh(1), triangles.b));
    return exact::with_integers(points, [&](const auto& integers) {
        exact::TurningTriangles turning(integers, *integers_);
        return ask(turning);
    });
}

std::optional<exact::Meeting> TurningPairs::decide(const TrianglePair& triangles, exact::TimeSpan time, double to) {
    return MeetingDecision(*this, known_, triangles).decide(time, to);
}

}  // namespace ecods
