// Two triangles of which every corner moves: on a straight line, or as polynomials of the time say.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "oracle/features.hpp"
#include "oracle/polynomial.hpp"

namespace ecods::oracle {

// Corners at time 0, and how far they go until time 1.
struct MovingTriangle {
    std::array<Vector<mpz_class>, 3> from, change;
};

class PairMotion {
  public:
    virtual ~PairMotion() = default;

    // When the closed triangles first share a point, which they do not at time 0; nothing if not up to time 1.
    virtual std::optional<Root> first_time() = 0;
    // All of feature_pairs() that share a point at that time, as vertices, open edges and open faces are then.
    virtual std::vector<std::size_t> features_at(Root& time) = 0;
};

// Of two triangles that move, a as a whole and b not at all.
std::unique_ptr<PairMotion> make_translation(const MovingTriangle& a, const MovingTriangle& b);
// Of any.
std::unique_ptr<PairMotion> make_motion(const MovingTriangle& a, const MovingTriangle& b);

// Coordinates of corners, times a polynomial that is positive from time 0 to 1.
using PolynomialCorners = std::array<Vector<Polynomial>, 3>;
// Makes the motion of two that have the same such factor, which divides some polynomials.
std::unique_ptr<PairMotion> make_motion(const PolynomialCorners& a, const PolynomialCorners& b,
                                        const Polynomial& factor);

}  // namespace ecods::oracle
