// Two bodies of which one turns, or both, or one turns and one goes straight, by pieces of the time: proofs that the
// bodies are apart throughout a piece, and the question at a single time. No root of a polynomial is computed, and no
// condition on features decides: it shares nothing with the first contacts of first_contact.hpp.
//
// On a piece of the time the quaternion is a linear form of two numbers u, v >= 0 that are not both 0: how far the time
// is from either end. The corners are then cubic forms over a common positive one; of the fifth degree if both turn. A
// direction, which may turn too, is a form; if all differences of two corners along it have coefficients of one sign,
// and not 0 at the ends, then the triangles are apart at all times of the piece.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "oracle/first_contact.hpp"
#include "oracle/vector.hpp"

namespace ecods::oracle {

class TurnSubdivision {
  public:
    TurnSubdivision(const TurningSoup& a, const Soup& b);
    TurnSubdivision(const TurningSoup& a, const TurningSoup& b);
    TurnSubdivision(const TurningSoup& a, const MovingSoup& b);

    // True if the bodies are proven to share no point from one time to another. Pieces are halved up to so many times;
    // no proof is found where they do share a point.
    bool are_apart(const mpq_class& from, const mpq_class& to, int depth) const;

    // True if the bodies share a point at this time.
    bool meet(const mpq_class& time) const;

  private:
    using Integers = Vector<mpz_class>;

    // One body, in the unit of both, and its quaternion in its own.
    struct Body {
        std::vector<std::array<Integers, 3>> arms;  // of each triangle: corners less the pivot
        Integers pivot, glide;
        mpz_class one = 1;
        std::array<mpz_class, 4> q;
        bool rests = false;
        std::vector<std::array<Integers, 3>> at_end;  // corners, if they go straight; `arms` has them at the start
    };
    // A soup that turns; or one that goes straight, if it has a pose at the end.
    struct Moved {
        TurningSoup soup;
        const Pose* end = nullptr;
    };
    TurnSubdivision(const Moved& a, const Moved& b);
    std::array<Body, 2> bodies_;
};

// Nothing, or what pieces of the time say against a first contact: that the bodies are not proven apart before it, or
// that they are at it, or at times around it that are nearer to it than the next doubles.
std::optional<std::string> contradiction(const TurnSubdivision& pieces, const std::optional<ExactContact>& contact);
std::optional<std::string> contradiction(const TurningSoup& a, const Soup& b,
                                         const std::optional<ExactContact>& contact);

}  // namespace ecods::oracle
