// TurningQuestion asks for the first contact of a body that turns with one that is translated or at rest, in a piece of
// the turn.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "bvh/axes/motion_axes.hpp"
#include "query/cast/meeting_question.hpp"
#include "query/cast/turning_pairs.hpp"

namespace ecods {

// A turn, for MeetingQuestion, one piece of its time after the other.
//
// In a piece every point of the body is within a margin of a straight motion (turning_points.hpp), which the axes of
// motion_axes.hpp bound. The margin is that of the points that are farthest from the axis, and falls as the square of
// the piece's angle.
//
// Bound. The places of the body at both ends of a piece are rounded. Each entry of its pose is computed like a corner
// in turning_points.hpp, from exact numbers, or from a pivot that is off by u' of itself: it is off by less than u'
// (140 (1
// + k) |sin| + 8) times the sum of magnitudes of its column; for the translation, these are the pivot's, times 140 (1 +
// k) |sin| alone, and the glide's. With the sum of such errors of a point, of its distance in place of its coordinates
// (a factor of sqrt(3)), and of the distance of both poses, this is less than 512 u' times the sum of magnitudes at
// rest and of the glide so far, and (1 + k) |sin| times the sum of magnitudes of what turns. About half of it is left
// over, for a center of the body that is posed so, and its distance from the other center.
// Claim: verify/proofs/turn_pieces.md
class TurnMotion : public TurningPairs {
  public:
    // Binds the bodies, b translated by `motion`. Everything that the arguments refer to must outlive this object.
    void bind(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, CastCounts& counts);

    // Binds the time between two times.
    void set_piece(double from, double to);
    // Returns a lower bound, on the axes, of the time in the piece at which the boxes of the bodies meet; nullopt if
    // they do not.
    std::optional<float> first_of_boxes();
    // True if the piece should be divided before it is searched, because it is far from straight, beside the bodies.
    bool is_wide() const noexcept { return may_divide_ && near_ > wide_; }
    // Returns a time inside of the piece; nullopt if it should not be divided.
    std::optional<double> middle() const noexcept;

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

  private:
    // The pose of the turning body at a time, relative to the translation of its pose at the start.
    struct Place {
        Mat3 R;
        Vec3 t;
    };
    Place place_at(const exact::HalfAngle& half) const;
    void require_moderate(double sizes, double way) const;

    const Mat3* a_start_ = nullptr;
    const Mat3* b_pose_ = nullptr;
    std::array<TreeAtEnds, 2> trees_;
    Vec3 between_ = Vec3::Zero();          // from the translation of a's pose at the start to that of b's
    double radius_ = 0;                    // upper bound of the distance of a's points from the axis
    double size_ = 0, arm_ = 0, way_ = 0;  // of the body and the distance of both, of the pivot beside it, of the glide
    double wide_ = 0, narrow_ = 0;
    double balls_ = 0;               // sum of the radii of balls that contain the bodies
    std::array<Vec3, 2> centers_{};  // of these balls: of a before its pose, of b as posed

    double from_ = 0, to_ = 1;
    exact::HalfAngle at_from_{}, at_to_{};
    std::array<Vec3, 2> gaps_{};  // from the center of b to that of a, at both ends
    exact::TurnPiece piece_;
    double near_ = 0;  // upper bound of the distance from the straight motion, without rounding
    double margin_ = 0;
    bool may_divide_ = false;
    MotionAxes axes_;
    std::uint64_t step_count_ = 0, step_max_ = 0, usual_step_max_ = 0;
};

using TurningQuestion = MeetingQuestion<TurnMotion>;

}  // namespace ecods
