// BothTurningPairs finds when pairs of triangles of two meshes first share a point, by bounds and exactly. Each mesh
// turns by a turn of its own.
#pragma once

#include <array>
#include <optional>

#include "ecods/turn.hpp"
#include "exact/measure/contact/both_turning_points.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/point/frame.hpp"
#include "query/cast/decide_meeting.hpp"

namespace ecods {

class BothTurningPairs : public EnclosedPairs<BothTurningPairs> {
  public:
    // Binds two meshes that turn. All objects that the arguments refer to must outlive this object.
    void bind(const Turning<MeshShape>& a, const Turning<MeshShape>& b, CastCounts& counts);

    // Does what MovingPairs::decide() does.
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  protected:
    const exact::TurnAngles& angles(std::size_t side) const noexcept { return angles_[side]; }

  private:
    friend class EnclosedPairs<BothTurningPairs>;
    friend class MeetingDecision<BothTurningPairs>;
    const Turning<MeshShape>& body(std::size_t side) const noexcept { return side == 0 ? *a_ : *b_; }
    const Mesh& mesh(std::size_t side) const noexcept { return body(side).what->mesh(); }
    std::array<exact::VertexRef, 6> corners_of(const TrianglePair& triangles) const;
    exact::BothTurningPoints points_of(const TrianglePair& triangles);
    template <class Function>
    auto ask_exactly(const TrianglePair& triangles, Function&& ask);

    const Turning<MeshShape>* a_ = nullptr;
    const Turning<MeshShape>* b_ = nullptr;
    exact::Frame frame_;
    std::array<exact::TurnAngles, 2> angles_;
    std::array<exact::TurnOfPoints, 2> turns_{};  // relative to the translation of a's pose at the start
    std::optional<std::array<exact::TurnIntegers, 2>> integers_;  // made when a pair is first decided exactly
};

}  // namespace ecods
