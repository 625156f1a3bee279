// SettlingMotion moves a body straight from where a turn ends, which is rarely at a pose of doubles, to a pose.
//
// With z = (w, v) the quaternion at the end of the turn, N its norm and Q its rotation times N, a point that was at p
// at the start of the way ends at c + Q (p - pivot) / N. Times N, that and all other points are integers in a common
// unit: triangles that move straight (moving_triangles.hpp). In doubles the end is a pose that is rounded once
// (RoundedLeg); its errors are added to those of the points, and to the boxes as a margin: coordinates are off by `off`
// on each axis at each end, so points by less than 2 `off`.
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

// A motion, for MeetingQuestion. Pairs of triangles that share a point at time 0 meet at time 0, in vertices 0.
class SettlingMotion : public StraightBoxes {
  public:
    // Binds a mesh that ends `leg` and goes to the pose `to`, and a mesh at rest. All arguments must outlive this
    // object.
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
    RoundedLeg end_;      // where the turn ends
    Pose rounded_to_;     // relative to the translation of b, as end_ is
    double to_off_ = 0;   // upper bound of errors of its points, as end_.off
    exact::Frame frame_;  // bodies: a at the end of the turn, b, a at `to`
    KnownMeetings known_;
};

}  // namespace ecods
