// TurningQuestion finds the first contact of a body that turns with a body that is translated or at rest, in one piece
// of the turn.
#pragma once

#include <array>

#include "query/cast/meeting_question.hpp"
#include "query/cast/turn_pieces.hpp"
#include "query/cast/turning_pairs.hpp"

namespace ecods {

// TurnMotion is the Motion of MeetingQuestion for a body that turns.
//
// In a piece, the distance of each point of the body from a straight motion is at most a margin (turning_points.hpp).
// Claim: verify/proofs/turn_pieces.md
class TurnMotion : public TurningPairs, public TurnPieces {
  public:
    // Binds the bodies. All arguments must outlive this object.
    void bind(const MeshShape& a, const TurnLeg& leg, const Posed<MeshShape>& b, CastCounts& counts);

    // Restricts the motion to the piece between two times.
    void set_piece(double from, double to);

  private:
    TurningBody body_;
    Vec3 between_ = Vec3::Zero();  // from the translation of a's pose at the start to that of b's
};

using TurningQuestion = MeetingQuestion<TurnMotion>;

}  // namespace ecods
