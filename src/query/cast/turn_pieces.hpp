// TurnPieces describes the motion of two bodies, of which at least one turns, in a piece of the time. A search sets one
// piece after the other.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "bvh/axes/motion_axes.hpp"
#include "ecods/shape.hpp"
#include "exact/measure/contact/half_angle.hpp"
#include "query/cast/turning_body.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// In a piece all points of the bodies are within a margin of straight motions, which the axes of motion_axes.hpp bound.
// The points that are farthest from the axis of a turn determine the margin; it falls as the square of the piece's
// angle. An arc leaves its chord only perpendicular to the axis of the turn, and a glide leaves its straight motion
// only along itself. Motions derive from this class, and bind the bodies and the pieces.
// Claim: verify/proofs/turn_pieces.md
class TurnPieces {
  public:
    // Returns a lower bound of the first meeting of the bodies' boxes in the piece, as time_of() takes it; nullopt if
    // they do not meet.
    std::optional<float> first_of_boxes();
    // Returns true if the piece should be divided before it is searched, because it is far from straight relative to
    // the size of the bodies.
    bool is_wide() const noexcept { return middle_ && near_ > wide_; }
    // Returns the time at which to divide the piece; nullopt if it should not be divided.
    const std::optional<double>& middle() const noexcept { return middle_; }

    // MeetingQuestion calls the following functions.
    const std::array<MotionSet, 2>& sets() const noexcept { return axes_.sets(); }
    const std::array<TreeAtEnds, 2>& trees() const noexcept { return trees_; }
    double begin() const noexcept { return from_; }
    double time_of(float bound) const noexcept;
    float bound_of(double time) const noexcept;
    // Counts a step of the search of this piece. Returns false after too many steps, so that the piece is divided; a
    // piece that should not be divided may take any number of steps.
    bool may_go_on() noexcept { return ++step_count_ <= step_max_; }
    // Returns true if the search of the piece was given up.
    bool is_given_up() const noexcept { return step_count_ > step_max_; }

  protected:
    // Bodies describes both bodies. half_a and half_b are half the sizes of boxes around the bodies at the start;
    // `travel` is an upper bound of the way of points of bodies that turn, and `size` is the sum of the magnitudes of
    // their coordinates. If b changes its size, half_b is the greatest vector of half sizes, and `least_b` the least
    // length of such a vector.
    struct Bodies {
        const MeshShape &a, &b;
        Vec3 half_a, half_b;
        double travel, size;
        double least_b = std::numeric_limits<double>::infinity();
    };
    void bind_bodies(const Bodies& bodies);

    // Sets the time of the piece. set_bounds() and set_places() must follow.
    void set_times(double from, double to) noexcept;

    // Bounds holds bounds that are valid in a piece.
    struct Bounds {
        double near;                    // upper bound of the bodies' distance from straight motions
        MotionMargin parts;             // upper bounds of the distance from straight motions, by parts
        double rounding;                // at the beginning, places are off by at most 512 u' times this number
        double later = 0;               // is added to `rounding` at the end, and in proportion to the time before
        double pace;                    // pace of the straight motions (TurnPiece)
        bool is_bounded;                // true if places are bounded, and the rotations known at both ends
        bool may_divide;                // true if places are bounded, and each rotation is known at one end at least
        std::array<double, 2> lengths;  // lengths at both ends of the quaternions whose angle is divided
    };
    void set_bounds(const Bounds& bounds) noexcept;
    // Sets the straight motions, which go between the places of the bodies at both ends. `between` is the vector from
    // the translation of a's pose at the start to the translation of b's pose.
    using Places = std::array<TurningBody::Place, 2>;
    void set_places(const Places& a, const Places& b, const Vec3& between);

    double from_ = 0, to_ = 1;

  private:
    std::optional<double> find_middle() const noexcept;

    std::array<TreeAtEnds, 2> trees_;
    std::array<Vec3, 2> centers_{};  // centers of balls that contain the bodies, before their poses
    double wide_ = 0, narrow_ = 0;
    double balls_ = 0;                     // sum of the radii of these balls
    std::array<Vec3, 2> gaps_{};           // from the center of b's ball to that of a's, at both ends
    exact::TurnPiece times_;               // only its pace is set
    std::array<double, 2> lengths_{1, 1};  // see Bounds
    double near_ = 0;                      // upper bound of the distance from the straight motions, without rounding
    double margin_ = 0;
    MotionMargin parts_;  // no more than margin_ in any direction
    std::optional<double> middle_;
    MotionAxes axes_;
    std::uint64_t step_count_ = 0, step_max_ = 0, usual_step_max_ = 0;
};

}  // namespace ecods
