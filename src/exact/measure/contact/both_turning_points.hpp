// BothTurningCorners computes the corners of two triangles, each of which turns by a turn of its own, at any time in
// [0, 1], in doubles with error bounds. It also bounds the distances of the corners from straight motions.
//
// Bound. In the bound of turning_points.hpp, all terms but 2 e_p and |p| come from the triangle that turns. Here each
// triangle adds its own terms, since the projections of each are off by as much as there. The larger one of two
// magnitudes is at most their sum.
//
// Pieces. In a piece of time two turns proceed along their chords at different paces. So both are compared with their
// straight motions at the same part t of the time. The pivot itself moves straight. Relative to it, a corner is within
// rho sagitta of the point l of its chord, and the points l and t of the chord are within |l - t| <= shift times its
// length of each other. So a corner is within
//     rho (sagitta + chord shift),   chord = 2 sin(half the piece's angle),
// of its straight motion, and a gap along a unit vector is at least the chord of the gaps at both ends, less the sum of
// both margins.
// Claim: verify/proofs/turn_pieces.md
#pragma once

#include "exact/measure/contact/turning_points.hpp"

namespace ecods::exact {

// BothTurningPoints holds the rounded corners of both triangles at time 0, an upper bound of their errors on any axis,
// and both turns.
struct BothTurningPoints {
    Points<6> start;
    double start_error;
    std::array<TurnOfPoints, 2> turns;
};

class BothTurningCorners {
  public:
    ECODS_ALWAYS_INLINE explicit BothTurningCorners(const BothTurningPoints& points) noexcept
        : start_(points.start, points.start_error),
          a_(points.start, 0, points.turns[0]),
          b_(points.start, 3, points.turns[1]) {
        is_bounded_ = start_.scale(a_, b_);
    }

    // Returns true if all numbers are small enough for the error bounds to hold.
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return is_bounded_; }

    // An At holds the corners at one time, and factors of the error bound of gaps, as in MovingCorners::error_at().
    struct At {
        HalfAngle a, b;
        Points<6> points;
        Point error;
    };
    ECODS_ALWAYS_INLINE At at(double s) const noexcept {
        At result{a_.angles().at(s), b_.angles().at(s), start_.points(), start_.errors()};
        a_.turn(result.a, result.points, 0, result.error);
        b_.turn(result.b, result.points, 3, result.error);
        return result;
    }

    // Returns, for each axis, an upper bound of the sum of both triangles' distances from their straight motions
    // between two times.
    ECODS_ALWAYS_INLINE Point margins(const At& from, const At& to) const noexcept {
        const Point a = a_.lags(a_.angles().piece(from.a, to.a)), b = b_.lags(b_.angles().piece(from.b, to.b));
        return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    }
    // Returns an upper bound of the sum of two ways, each of one corner of a triangle, from the time of `at` to any
    // time at most `span` from it.
    ECODS_ALWAYS_INLINE double way(const At& at, double span) const noexcept {
        return a_.way(at.a, span) + b_.way(at.b, span);
    }

  private:
    StartCorners start_;
    TurningSide a_, b_;
    bool is_bounded_;
};

}  // namespace ecods::exact
