// TurnPieces is a motion of two bodies of which one turns, or both, in one piece of time after the other.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "bvh/axes/motion_axes.hpp"
#include "ecods/shape.hpp"
#include "exact/measure/contact/half_angle.hpp"
#include "query/cast/turning_body.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// In a piece all points of the bodies are within a margin of straight motions, which the axes of motion_axes.hpp bound.
// The margin is that of the points that are farthest from an axis of a turn, and falls as the square of the piece's
// angle. An arc leaves its chord across the axis of its turn only, and a glide is off along itself. A motion derives
// from this class, and binds its bodies and its pieces.
// Claim: verify/proofs/turn_pieces.md
class TurnPieces {
  public:
    // Returns a lower bound, on the axes, of the time in the piece at which the boxes of the bodies meet; nullopt if
    // they do not.
    std::optional<float> first_of_boxes();
    // True if the piece should be divided before it is searched, because it is far from straight, beside the bodies.
    bool is_wide() const noexcept { return middle_ && near_ > wide_; }
    // Returns a time inside of the piece; nullopt if it should not be divided.
    const std::optional<double>& middle() const noexcept { return middle_; }

    // MeetingQuestion calls the following functions.
    const std::array<MotionSet, 2>& sets() const noexcept { return axes_.sets(); }
    const std::array<TreeAtEnds, 2>& trees() const noexcept { return trees_; }
    double begin() const noexcept { return from_; }
    double time_of(float bound) const noexcept;
    float bound_of(double time) const noexcept;
    // Counts a step of the search of this piece. A piece that takes too many should be divided; a piece that may not be
    // divided takes any number.
    bool may_go_on() noexcept { return ++step_count_ <= step_max_; }
    // True if the search of the piece was given up.
    bool is_given_up() const noexcept { return step_count_ > step_max_; }

  protected:
    // Both bodies: half the sizes of boxes around them at the start, how far their points may go, and the sum of the
    // magnitudes of their coordinates.
    struct Bodies {
        const MeshShape &a, &b;
        Vec3 half_a, half_b;
        double travel, size;
    };
    void bind_bodies(const Bodies& bodies);

    // Sets the time of the piece. set_bounds() and set_places() must follow.
    void set_times(double from, double to) noexcept;

    // Bounds of a piece.
    struct Bounds {
        double near;                    // distance of the bodies from straight motions
        MotionMargin parts;             // the same by parts
        double rounding;                // places are off by at most 512 u' times this
        double pace;                    // of the straight motions: TurnPiece has it
        bool is_bounded;                // true if places are bounded, and the rotations known at both ends
        bool may_divide;                // true if places are bounded, and each rotation is known at one end at least
        std::array<double, 2> lengths;  // of the quaternions whose angle is divided, at both ends
    };
    void set_bounds(const Bounds& bounds) noexcept;
    // Binds the straight motions, between places at both ends; `between` is the vector from the translation of a's pose
    // at the start to that of b's.
    using Places = std::array<TurningBody::Place, 2>;
    void set_places(const Places& a, const Places& b, const Vec3& between);

    double from_ = 0, to_ = 1;

  private:
    std::optional<double> find_middle() const noexcept;

    std::array<TreeAtEnds, 2> trees_;
    std::array<Vec3, 2> centers_{};  // of balls that contain the bodies, before their poses
    double wide_ = 0, narrow_ = 0;
    double balls_ = 0;                     // sum of the radii of these balls
    std::array<Vec3, 2> gaps_{};           // from the center of b's ball to that of a's, at both ends
    exact::TurnPiece times_;               // has the pace
    std::array<double, 2> lengths_{1, 1};  // Bounds has them
    double near_ = 0;                      // upper bound of the distance from the straight motions, without rounding
    double margin_ = 0;
    MotionMargin parts_;  // no more than margin_ in any direction
    std::optional<double> middle_;
    MotionAxes axes_;
    std::uint64_t step_count_ = 0, step_max_ = 0, usual_step_max_ = 0;
};

}  // namespace ecods
