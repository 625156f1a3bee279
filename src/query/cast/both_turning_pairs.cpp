#include "query/cast/both_turning_pairs.hpp"

#include <algorithm>

#include "exact/measure/contact/both_turning_triangles.hpp"
#include "query/cast/turn_leg.hpp"
#include "query/cast/turn_vector.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

void BothTurningPairs::bind(const Turning<MeshShape>& a, const Turning<MeshShape>& b, CastCounts& counts) {
    a_ = &a;
    b_ = &b;
    bind_counts(counts);
    const exact::MeshExtent &extent_a = MeshShapeAccess::tree(*a.what).extent,
                            &extent_b = MeshShapeAccess::tree(*b.what).extent;
    const std::array<exact::BodyRef, 2> bodies{
        {{&a.what->mesh(), &extent_a, &a.pose}, {&b.what->mesh(), &extent_b, &b.pose}}};
    frame_.bind(bodies);
    for (std::size_t side = 0; side < 2; ++side) {
        const Turn& turn = body(side).turn;
        angles_[side] = exact::TurnAngles(turn.q.w, vector_of(turn.q));
        // Both pivots are relative to the translation of a's pose.
        turns_[side] = round_leg(leg_of(a.pose, turn), extent_a, b.pose).turn_of_points(angles_[side]);
    }
    integers_.reset();
}

std::array<exact::VertexRef, 6> BothTurningPairs::corners_of(const TrianglePair& triangles) const {
    return exact::corners_of(mesh(0).triangles()[triangles.a], mesh(1).triangles()[triangles.b]);
}

exact::BothTurningPoints BothTurningPairs::points_of(const TrianglePair& triangles) {
    return {frame_.rounded(corners_of(triangles)), std::max(frame_.delta(0), frame_.delta(1)), turns_};
}

template <class Function>
auto BothTurningPairs::ask_exactly(const TrianglePair& triangles, Function&& ask) {
    ++counts_->exact;
    if (!integers_) {
        const auto integers_of = [&](const Turn& turn) { return exact::TurnIntegers(turn.q.w, vector_of(turn.q)); };
        integers_ = {integers_of(a_->turn), integers_of(b_->turn)};
    }
    static const Pose world;
    exact::PosedPoints<10> points;
    std::ranges::copy(frame_.posed(corners_of(triangles)), points.begin());
    for (std::size_t side = 0; side < 2; ++side) {
        points[6 + 2 * side] = {&world, &body(side).turn.pivot_from};
        points[7 + 2 * side] = {&world, &body(side).turn.pivot_to};
    }
    return exact::with_integers(points, [&](const auto& integers) {
        exact::BothTurningTriangles turning(integers, (*integers_)[0], (*integers_)[1]);
        return ask(turning);
    });
}

std::optional<exact::Meeting> BothTurningPairs::decide(const TrianglePair& triangles, exact::TimeSpan time, double to) {
    return MeetingDecision(*this, known_, triangles).decide(time, to);
}

}  // namespace ecods
