// The oracle's first contacts: what include/ecods/cast.hpp promises, pair of triangles by pair, and without a tree.
//
// Of a translation the first time is the least number of a linear program: weights of the corners of either triangle
// that make one point of both. Where every point moves by itself, features meet at the common roots of polynomials of
// the time, of degree 3 or less; each root from 0 to 1 is asked whether the features really share a point there. Where
// a body turns, coordinates are polynomials over the squared length of the quaternion, which has no root and is divided
// out, whether the other one rests or goes straight; where both turn, over the product of both. What is left out: pairs
// of triangles of which the boxes of all their places, in integers, do not overlap, and those whose projections on some
// line are apart at the start and at the first time that is known so far.
#pragma once

#include <array>
#include <optional>

#include "oracle/distance.hpp"
#include "oracle/polynomial.hpp"

namespace ecods::oracle {

struct ExactContact {
    Root time;           // of the first pair of triangles
    double rounded = 0;  // rounded once; features are of all pairs whose times round to it
    Closeness kind = Closeness::intersecting;
    NamedFeature a, b;
    NamedFeature b_first, a_second;  // what is chosen when b is asked about with a
};

// Of a, which moves by time times `motion`, with b; nothing if there is none up to time 1.
std::optional<ExactContact> first_contact(const Soup& a, const Vec3& motion, const Soup& b);

// A soup on its way from its own pose to another.
struct MovingSoup {
    Soup from;
    Pose to;
};
std::optional<ExactContact> first_contact(const MovingSoup& a, const MovingSoup& b);

// A soup whose vertices go to those of another one with the same triangles.
struct DeformingSoup {
    Soup from, to;
};
std::optional<ExactContact> first_contact(const DeformingSoup& a, const DeformingSoup& b);

// A soup that turns from its own pose, as include/ecods/turn.hpp says, by a quaternion w, x, y, z.
struct TurningSoup {
    Soup from;
    std::array<double, 4> q;
    Vec3 pivot_from, pivot_to;
};
std::optional<ExactContact> first_contact(const TurningSoup& a, const Soup& b);
std::optional<ExactContact> first_contact(const TurningSoup& a, const TurningSoup& b);
std::optional<ExactContact> first_contact(const TurningSoup& a, const MovingSoup& b);

}  // namespace ecods::oracle
