// BothTurningQuestion asks for the first contact of two bodies that turn, in a piece of their time.
#pragma once

#include <array>

#include "query/cast/both_turning_pairs.hpp"
#include "query/cast/meeting_question.hpp"
#include "query/cast/turn_pieces.hpp"

namespace ecods {

// Two turns, for MeetingQuestion.
//
// In a piece every point of a body is within a margin of a straight motion, at the same time of the piece
// (both_turning_points.hpp). The sum of both margins is that of the bodies, each across an axis of its own.
// Claim: verify/proofs/turn_pieces.md
class BothTurnMotion : public BothTurningPairs, public TurnPieces {
  public:
    // Binds the bodies. Everything that the arguments refer to must outlive this object.
    void bind(const Turning<MeshShape>& a, const Turning<MeshShape>& b, CastCounts& counts);

    // Binds the time between two times.
    void set_piece(double from, double to);

  private:
    std::array<TurningBody, 2> bodies_;
    Vec3 between_ = Vec3::Zero();  // from the translation of a's pose at the start to that of b's
};

using BothTurningQuestion = MeetingQuestion<BothTurnMotion>;

}  // namespace ecods
