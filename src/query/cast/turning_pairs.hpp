// TurningPairs finds when pairs of triangles of two meshes first share a point, by bounds and exactly. The first mesh
// turns; the second one is translated or at rest.
#pragma once

#include <array>
#include <optional>

#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/point/frame.hpp"
#include "query/cast/decide_meeting.hpp"
#include "query/cast/turn_leg.hpp"

namespace ecods {

class TurningPairs : public EnclosedPairs<TurningPairs> {
  public:
    // Binds mesh a, which turns, and mesh b. All arguments must outlive this object.
    void bind(const MeshShape& a, const TurnLeg& leg, const Posed<MeshShape>& b, CastCounts& counts);

    // Does what MovingPairs::decide() does.
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  protected:
    const exact::TurnAngles& angles() const noexcept { return angles_; }
    const RoundedLeg& rounded() const noexcept { return rounded_; }

  private:
    friend class EnclosedPairs<TurningPairs>;
    friend class MeetingDecision<TurningPairs>;
    const Mesh& mesh(std::size_t side) const noexcept { return side == 0 ? a_->mesh() : b_->what->mesh(); }
    std::array<exact::VertexRef, 6> corners_of(const TrianglePair& triangles) const;
    exact::TurningPoints points_of(const TrianglePair& triangles);
    template <class Function>
    auto ask_exactly(const TrianglePair& triangles, Function&& ask);

    const MeshShape* a_ = nullptr;
    const TurnLeg* leg_ = nullptr;
    const Posed<MeshShape>* b_ = nullptr;
    exact::Frame frame_;
    exact::TurnAngles angles_;
    RoundedLeg rounded_;
    std::optional<exact::TurnIntegers> integers_;  // made when a pair is first decided exactly
};

}  // namespace ecods
