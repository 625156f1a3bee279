// TurningCorners computes the corners of a triangle that turns and of one at rest, at any time in [0, 1], in doubles
// with error bounds. It bounds how far a turn is from a straight motion, too.
//
// Places. With half the angle (half_angle.hpp) and g = p - c, a corner is at
//     x = p + s m + 2 sin cos d1 + 2 sin^2 d2,   d1 = e x g,   d2 = e x d1.
// So only the way of the corner is off because the angle is, which is small for small angles.
//
// Bound. Let e_p bound the errors of corners and e_g those of g on each axis, G >= |g|. With a factor of 4.01 u' of e,
// d1 is off by 6.2 u' G + 1.42 e_g on each axis, and d2 by 15.1 u' G + 2.02 e_g. The factors of d1 and d2 are at most 2
// |sin|, and off by 32 u' (1 + k) |sin|. The glide m is off by e_m, and its product by u' s |m| more. Three sums and
// the products add 4.1 u' of all terms. So x is off by
//     e_p + s e_m + 7 |sin| e_g + 140 u' (1 + k) |sin| G + 6.1 u' (|p| + s |m|).
// A projection on n and the difference of two projections add, as in moving_points.hpp, 10.2 u' |n| (|p| + s |m| + 4
// |sin| G), with |p| the larger magnitude of both triangles. The other triangle is off by e_p. The bound
//     1.125 (2 e_p + s e_m + 8 |sin| e_g) + 32 u' (|p| + s |m|) + 256 u' (1 + k) |sin| G
// also covers its own rounding. Scaling and underflow are as in moving_points.hpp.
//
// Pieces. Let w0, w1, w2 be the weights of a piece of a turn (half_angle.hpp), t in [0, 1] the part of its time, N = (1
// - t)^2 w0 + 2 t (1 - t) w1 + t^2 w2 and l = (t (1 - t) w1 + t^2 w2) / N. Then every corner is within
//     rho sagitta + |m| shift      of the point l of the straight line between its places at both ends,
// with rho the distance of the corner from the axis, and one l for all corners. So a gap along a unit vector is at
// least the chord of the gaps at both ends, less this margin. The claim has the proof.
// Claim: verify/proofs/turn_pieces.md
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/measure/contact/half_angle.hpp"
#include "exact/measure/contact/moving_points.hpp"

namespace ecods::exact {

// Holds the rounded corners of both triangles at time 0, the pivot at time 0 and its way, and upper bounds of the
// errors of corners and of the pivot on any axis. `angles` must outlive users.
struct TurningPoints {
    Points<6> start;
    double start_error;
    Point pivot, glide;
    double pivot_error, glide_error;
    const TurnAngles* angles;
};

class TurningCorners {
  public:
    static constexpr double underflow = 0x1p-600;

    ECODS_ALWAYS_INLINE explicit TurningCorners(const TurningPoints& points) noexcept : angles_(*points.angles) {
        const Point origin = points.start[0];
        double most_before = std::max(points.start_error, points.pivot_error), size = 0, radius = 0;
        std::array<Point, 3> arm;
        for (std::size_t i = 0; i < 6; ++i) {
            most_before = std::max(most_before, largest(points.start[i]));
            start_[i] = minus(points.start[i], origin);
            for (std::size_t k = 0; k < 3; ++k) most_[k] = std::max(most_[k], std::abs(start_[i][k]));
        }
        most_before = std::max({most_before, largest(points.pivot), largest(points.glide)});
        for (std::size_t i = 0; i < 3; ++i) {
            arm[i] = minus(points.start[i], points.pivot);
            arm_ = std::max(arm_, sum_of_magnitudes(arm[i]));
        }
        size = std::max({largest(most_), largest(points.glide), arm_});
        is_bounded_ = most_before < 0x1p1000 && size > 0x1p-400 && angles_.is_bounded();
        const double scale = MovingCorners::inverse_power(size);
        for (Point& p : start_) p = times(p, scale);
        most_ = times(most_, scale);
        glide_ = times(points.glide, scale);
        arm_ *= scale;
        start_error_ = scale * points.start_error;
        glide_error_ = scale * points.glide_error;
        arm_error_ = start_error_ + (scale * points.pivot_error + 2 * two_u * arm_);
        for (std::size_t i = 0; i < 3; ++i) {
            across_[i] = cross(angles_.axis(), times(arm[i], scale));
            inwards_[i] = cross(angles_.axis(), across_[i]);
            radius = std::max(radius, dot(across_[i], across_[i]));
        }
        // An upper bound: the errors are those of d1, for which sqrt(3) (1.42 e_g + 6.2 u' G) is less than these terms.
        radius_ = std::sqrt(radius) * (1 + 8 * two_u) + 4 * arm_error_ + 16 * two_u * arm_ + underflow;
        way_ = std::sqrt(dot(glide_, glide_)) * (1 + 8 * two_u) + 2 * glide_error_;
    }

    // True if all numbers are small enough for the error bounds to hold.
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return is_bounded_; }

    // The corners at one time, and factors of the error bound of gaps, as in MovingCorners::error_at().
    struct At {
        HalfAngle half;
        Points<6> points;
        Point error;
    };
    ECODS_ALWAYS_INLINE At at(double s) const noexcept {
        At result{angles_.at(s), start_, {}};
        const HalfAngle& half = result.half;
        const double turned = 2 * half.sin * half.cos, inward = 2 * half.sin * half.sin, sin = std::abs(half.sin);
        const double is_off = half.condition < TurnAngles::condition_max ? 0 : std::numeric_limits<double>::infinity();
        const double common = 1.125 * (2 * start_error_ + s * glide_error_ + 8 * sin * arm_error_) +
                              256 * two_u * (1 + half.condition) * sin * arm_ + is_off;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                result.points[i][k] =
                    ((start_[i][k] + s * glide_[k]) + turned * across_[i][k]) + inward * inwards_[i][k];
            }
            result.error[k] = common + 32 * two_u * (most_[k] + s * std::abs(glide_[k]));
        }
        return result;
    }

    ECODS_ALWAYS_INLINE TurnPiece piece(const At& from, const At& to) const noexcept {
        return angles_.piece(from.half, to.half);
    }
    // Returns upper bounds, on each axis, of how far corners are from their straight motion, for a piece of this length
    // in time. A sagitta is across the axis of the turn, so coordinate k of a vector of this length is at most sqrt(1 -
    // e_k^2) of it; both other coordinates of e are off by 4.01 u' of themselves, or lost if they are below 2^-500. A
    // glide that is lost to underflow is below 2^-620.
    ECODS_ALWAYS_INLINE Point margins(const TurnPiece& piece, double length) const noexcept {
        const Point& e = angles_.axis();
        Point result;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = e[(k + 1) % 3], y = e[(k + 2) % 3];
            const double across = std::sqrt(x * x + y * y) * (1 + 16 * two_u) + 0x1p-499;
            const double way = std::abs(glide_[k]) + 2 * glide_error_;
            result[k] = (radius_ * piece.sagitta * across + way * length * piece.shift) * (1 + 16 * two_u) + underflow;
        }
        return result;
    }
    // Returns an upper bound of the way of a corner from the time of `at` to any time at most `span` from it.
    ECODS_ALWAYS_INLINE double way(const At& at, double span) const noexcept {
        return 1.0625 * span * (way_ + 2 * radius_ * angles_.speed(at.half, span)) + underflow;
    }

  private:
    const TurnAngles& angles_;
    Points<6> start_;
    Point glide_, most_{};
    std::array<Point, 3> across_, inwards_;         // d1 and d2 of the corners that turn
    double arm_ = 0;                                // G
    double start_error_, arm_error_, glide_error_;  // e_p, e_g, e_m
    double radius_, way_;                           // upper bounds of the distance from the axis, and of |m|
    bool is_bounded_;
};

}  // namespace ecods::exact
