// TurnAndStraightQuestion finds the first contact of a body that turns with a body whose points move straight, in one
// piece of the time.
#pragma once

#include "query/cast/meeting_question.hpp"
#include "query/cast/straight_body.hpp"
#include "query/cast/turn_and_straight_pairs.hpp"
#include "query/cast/turn_pieces.hpp"

namespace ecods {

// TurnAndStraightMotion is the Motion of MeetingQuestion for a turn and a straight motion.
//
// In a piece, the distance of each point of the body that turns from a straight motion, at the same part of the time,
// is at most a margin (both_turning_points.hpp). The points of the other body move straight, so they have no margin.
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
