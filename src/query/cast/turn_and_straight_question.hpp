// TurnAndStraightQuestion asks for the first contact of a body that turns with one whose points move straight, in a
// piece of the time.
#pragma once

#include "query/cast/meeting_question.hpp"
#include "query/cast/straight_body.hpp"
#include "query/cast/turn_and_straight_pairs.hpp"
#include "query/cast/turn_pieces.hpp"

namespace ecods {

// TurnAndStraightMotion is a turn and a straight motion, for MeetingQuestion.
//
// In a piece every point of the body that turns is within a margin of a straight motion, at the same time of the piece
// (both_turning_points.hpp). Points of the other body are on one.
// Claim: verify/proofs/turn_pieces.md
class TurnAndStraightMotion : public TurnAndStraightPairs, public TurnPieces {
  public:
    // Binds the bodies. Everything that the arguments refer to must outlive this object.
    void bind(const Turning<MeshShape>& a, const Moving<MeshShape>& b, CastCounts& counts);

    // Restricts the motion to the piece between two times.
    void set_piece(double from, double to);

  private:
    TurningBody turning_;
    StraightBody straight_;
    Vec3 between_ = Vec3::Zero();  // from the translation of a's pose at the start to that of b's
};

using TurnAndStraightQuestion = MeetingQuestion<TurnAndStraightMotion>;

}  // namespace ecods
