// BothTurningQuestion finds the first contact of two bodies that turn, in one piece of the time.
#pragma once

#include <array>

#include "query/cast/both_turning_pairs.hpp"
#include "query/cast/meeting_question.hpp"
#include "query/cast/turn_pieces.hpp"

namespace ecods {

// BothTurnMotion is the Motion of MeetingQuestion for two bodies that turn.
//
// In a piece, the distance of each point of a body from its straight motion at the same time is at most a margin
// (both_turning_points.hpp). The margin of the pair is the sum of the margins of both bodies; each margin is across the
// axis of its own turn.
// Claim: verify/proofs/turn_pieces.md
class BothTurnMotion : public BothTurningPairs, public TurnPieces {
  public:
    // Binds the bodies. Everything that the arguments refer to must outlive this object.
    void bind(const Turning<MeshShape>& a, const Turning<MeshShape>& b, CastCounts& counts);

    // Restricts the motion to the piece between two times.
    void set_piece(double from, double to);

  private:
    std::array<TurningBody, 2> bodies_;
    Vec3 between_ = Vec3::Zero();  // from the translation of a's pose at the start to that of b's
};

using BothTurningQuestion = MeetingQuestion<BothTurnMotion>;

}  // namespace ecods
