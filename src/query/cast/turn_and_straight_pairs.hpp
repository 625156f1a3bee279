// TurnAndStraightPairs finds when pairs of triangles first share a point, one of a mesh that turns and one of a mesh
// whose points move straight from one pose to another, by bounds and exactly.
#pragma once

#include <array>
#include <optional>

#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/point/frame.hpp"
#include "query/cast/decide_meeting.hpp"
#include "query/cast/turn_leg.hpp"

namespace ecods {

class TurnAndStraightPairs : public EnclosedPairs<TurnAndStraightPairs> {
  public:
    // Binds mesh a, which turns, and mesh b, whose points move straight. All arguments must outlive this object.
    void bind(const Turning<MeshShape>& a, const Moving<MeshShape>& b, CastCounts& counts);

    // Does what MovingPairs::decide() does.
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  protected:
    const exact::TurnAngles& angles() const noexcept { return angles_; }
    const RoundedLeg& rounded() const noexcept { return rounded_; }

  private:
    friend class EnclosedPairs<TurnAndStraightPairs>;
    friend class MeetingDecision<TurnAndStraightPairs>;
    const Mesh& mesh(std::size_t side) const noexcept { return *frame_.body(side).mesh; }
    exact::TurnAndStraightPoints points_of(const TrianglePair& triangles);
    template <class Function>
    auto ask_exactly(const TrianglePair& triangles, Function&& ask);

    const Turning<MeshShape>* a_ = nullptr;
    const Moving<MeshShape>* b_ = nullptr;
    exact::Frame frame_;  // bodies: a and b at the start, b at the end
    exact::TurnAngles angles_;
    RoundedLeg rounded_;
    std::optional<exact::TurnIntegers> integers_;  // made when a pair is first decided exactly
};

}  // namespace ecods
