// SettlingMotion moves a body straight from the end of a turn, whose pose is rarely exact in doubles, to a given pose.
//
// Let z = (w, v) be the quaternion at the end of the turn, N = w^2 + v.v, Q the rotation times N, and c the pivot's
// place at the end of the turn. A point that was at p at the start of the way is then at c + Q (p - pivot) / N.
// Multiplied by N, this point and all other points are integers in a common unit, so the triangles move straight as in
// moving_triangles.hpp. In doubles, the end of the turn is a pose that is rounded once (RoundedLeg). The error of this
// pose is added to the errors of the points, and to the boxes as a margin: coordinates are off by at most `off` on each
// axis at each end, so points are off by less than 2 `off`.
#pragma once

#include <optional>

#include "exact/measure/contact/moving_triangles.hpp"
#include "exact/point/frame.hpp"
#include "query/cast/decide_meeting.hpp"
#include "query/cast/meeting_question.hpp"
#include "query/cast/moving_question.hpp"
#include "query/cast/turn_leg.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// SettlingMotion is a Motion of MeetingQuestion. If triangles share a point at time 0, decide() returns a meeting of
// vertex 0 of both at time 0.
class SettlingMotion : public StraightBoxes {
  public:
    // Binds mesh a, which moves straight from its place at the end of `leg` to the pose `to`, and mesh b, which is at
    // rest. All arguments must outlive this object.
    void bind(const MeshShape& a, const TurnLeg& leg, const Pose& to, const Posed<MeshShape>& b, CastCounts& counts);

    std::optional<exact::TimeSpan> bound(const TrianglePair& triangles, double from, double to, exact::Effort effort);
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  private:
    friend class MeetingDecision<SettlingMotion>;
    const Mesh& mesh(std::size_t side) const noexcept { return side == 0 ? a_->mesh() : b_->what->mesh(); }
    exact::MovingPoints points_of(const TrianglePair& triangles);
    template <class Function>
    auto ask_exactly(const TrianglePair& triangles, Function&& ask);

    const MeshShape* a_ = nullptr;
    const TurnLeg* leg_ = nullptr;
    const Pose* to_ = nullptr;
    const Posed<MeshShape>* b_ = nullptr;
    CastCounts* counts_ = nullptr;
    RoundedLeg end_;      // the end of the turn in doubles
    Pose rounded_to_;     // relative to the translation of b, as end_ is
    double to_off_ = 0;   // upper bound of the errors of points at this pose, as end_.off is at the end of the turn
    exact::Frame frame_;  // bodies: a at the end of the turn, b, a at `to`
    KnownMeetings known_;
};

}  // namespace ecods
