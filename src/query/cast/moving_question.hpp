// MovingQuestion finds the first contact of two meshes whose points move straight: between two poses of a rigid mesh,
// or between the vertices of a mesh that deforms.
#pragma once

#include <array>
#include <optional>

#include "base/outward.hpp"
#include "bvh/axes/motion_axes.hpp"
#include "ecods/cast.hpp"
#include "query/cast/meeting_question.hpp"
#include "query/cast/moving_pairs.hpp"

namespace ecods {

// Returns a lower bound, computed on the axes, of the time at which the boxes of the trees' roots meet; nullopt if they
// never meet.
std::optional<float> first_of_roots(const MotionAxes& axes, const TreeAtEnds& a, const TreeAtEnds& b);

// StraightBoxes holds the trees and axes of two bodies whose points move straight. It has all functions of a Motion of
// MeetingQuestion except bound() and decide().
class StraightBoxes {
  public:
    // Returns a lower bound of the time at which the boxes of the bodies meet; nullopt if they never do.
    std::optional<float> first_of_boxes();

    const std::array<MotionSet, 2>& sets() const noexcept { return axes_.sets(); }
    const std::array<TreeAtEnds, 2>& trees() const noexcept { return trees_; }
    static constexpr double begin() noexcept { return 0; }
    static double time_of(float bound) noexcept { return static_cast<double>(bound); }
    static float bound_of(double time) noexcept { return round_up(time); }
    static constexpr bool may_go_on() noexcept { return true; }

  protected:
    MotionAxes axes_;
    std::array<TreeAtEnds, 2> trees_;
};

// StraightMotion is the Motion of MeetingQuestion for two bodies whose points move straight.
class StraightMotion : public MovingPairs, public StraightBoxes {
  public:
    // Binds the trees and axes to two meshes. All objects that the arguments refer to must outlive this object.
    void bind_boxes(const MeshAtEnds& a, const MeshAtEnds& b);
};

using MovingQuestion = MeetingQuestion<StraightMotion>;

}  // namespace ecods
