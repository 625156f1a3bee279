// TurnAndStraightCorners computes the corners of a triangle that turns and of a triangle whose corners move straight,
// at any time in [0, 1], in doubles with error bounds. It also bounds the distances of the corners from straight
// motions.
//
// Bound. A straight corner at time s is computed as P (1 - s) + Q s. Let e_p and e_q bound the errors of P and Q on
// each axis, and |p| and |q| be the largest magnitudes of corners at time 0 and of these Q. As in moving_points.hpp the
// corner is off by
//     (1 - s) e_p + s e_q + 4.1 u' (|p| + s |q|),
// of which one u' is the subtraction of the reference point. In the bound of turning_points.hpp, in which e_p counts
// twice, the terms in |p| are then 20.4 u', below its 32 u'. Projections and their difference add 10.2 u' |n| s |q|. So
//     1.125 s e_q + 32 u' s |q|
// is added to that bound, and also covers its own rounding.
//
// Pieces. The triangle that moves straight has no margin. The one that turns has the margin of one of two triangles
// that turn (both_turning_points.hpp), since motions are compared at the same time.
// Claim: verify/proofs/turn_pieces.md
#pragma once

#include "exact/measure/contact/turning_points.hpp"

namespace ecods::exact {

// TurnAndStraightPoints holds the rounded corners of both triangles at time 0; the turn of the first triangle; and the
// corners of the second triangle at time 1. Each error is an upper bound on any axis.
struct TurnAndStraightPoints {
    Points<6> start;
    double start_error;
    TurnOfPoints turn;
    Points<3> end;
    double end_error;
};

// StraightSide computes the places of the second triangle, whose corners move straight.
class StraightSide {
  public:
    // Takes the corners at time 0 and 1. The caller must call scale() next.
    ECODS_ALWAYS_INLINE explicit StraightSide(const TurnAndStraightPoints& points) noexcept
        : end_error_(points.end_error), largest_given_(points.end_error) {
        for (std::size_t i = 0; i < 3; ++i) {
            largest_given_ = std::max(largest_given_, largest(points.end[i]));
            end_[i] = minus(points.end[i], points.start[0]);
            ways_[i] = minus(points.end[i], points.start[3 + i]);
            for (std::size_t k = 0; k < 3; ++k) most_[k] = std::max(most_[k], std::abs(end_[i][k]));
            size_ = std::max({size_, largest(end_[i]), largest(ways_[i])});
        }
    }
    // The next functions have the contracts of the functions with the same names in TurningSide.
    ECODS_ALWAYS_INLINE double largest_given() const noexcept { return largest_given_; }
    ECODS_ALWAYS_INLINE double size() const noexcept { return size_; }
    ECODS_ALWAYS_INLINE static bool is_bounded() noexcept { return true; }
    ECODS_ALWAYS_INLINE void scale(double scale, double start_error) noexcept {
        end_error_ *= scale;
        most_ = times(most_, scale);
        double way = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            end_[i] = times(end_[i], scale);
            ways_[i] = times(ways_[i], scale);
            way = std::max(way, dot(ways_[i], ways_[i]));
        }
        way_ = std::sqrt(way) * (1 + 8 * two_u) + 2 * (start_error + end_error_) + TurningSide::underflow;
    }
    ECODS_ALWAYS_INLINE double way(double span) const noexcept { return 1.0625 * span * way_ + TurningSide::underflow; }

    // Replaces the last three corners, which are at their places at time 0, by their places at `time`, and adds the
    // error terms of the motion to the factors of the error bound of gaps.
    ECODS_ALWAYS_INLINE void go(double time, Points<6>& points, Point& error) const noexcept {
        const double rest = 1 - time;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < 3; ++i) points[3 + i][k] = points[3 + i][k] * rest + end_[i][k] * time;
            error[k] += 1.125 * time * end_error_ + 32 * two_u * time * most_[k];
        }
    }

  private:
    std::array<Point, 3> end_, ways_;
    Point most_{};
    double end_error_, largest_given_;
    double size_ = 0;
    double way_ = 0;  // upper bound of the length of a corner's way
};

class TurnAndStraightCorners {
  public:
    ECODS_ALWAYS_INLINE explicit TurnAndStraightCorners(const TurnAndStraightPoints& points) noexcept
        : start_(points.start, points.start_error), turning_(points.start, 0, points.turn), straight_(points) {
        is_bounded_ = start_.scale(turning_, straight_);
    }

    // Returns true if all numbers are small enough for the error bounds to hold.
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return is_bounded_; }

    // An At holds the corners at one time, and factors of the error bound of gaps, as in MovingCorners::error_at().
    struct At {
        HalfAngle half;
        Points<6> points;
        Point error;
    };
    ECODS_ALWAYS_INLINE At at(double s) const noexcept {
        At result{turning_.angles().at(s), start_.points(), start_.errors()};
        turning_.turn(result.half, result.points, 0, result.error);
        straight_.go(s, result.points, result.error);
        return result;
    }

    // The next two functions have the contracts of the functions with the same names in BothTurningCorners.
    ECODS_ALWAYS_INLINE Point margins(const At& from, const At& to) const noexcept {
        return turning_.lags(turning_.angles().piece(from.half, to.half));
    }
    ECODS_ALWAYS_INLINE double way(const At& at, double span) const noexcept {
        return turning_.way(at.half, span) + straight_.way(span);
    }

  private:
    StartCorners start_;
    TurningSide turning_;
    StraightSide straight_;
    bool is_bounded_;
};

}  // namespace ecods::exact
