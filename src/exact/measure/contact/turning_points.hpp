// TurningCorners computes the corners of a triangle that turns and of a triangle at rest, at any time in [0, 1], in
// doubles with error bounds. It also bounds the distance of a turn from a straight motion.
//
// Places. With half the angle (half_angle.hpp) and g = p - c, a corner is at
//     x = p + s m + 2 sin cos d1 + 2 sin^2 d2,   d1 = e x g,   d2 = e x d1.
// So an error of the angle affects only the way of the corner, which is small for small angles.
//
// Bound. Let e_p bound the errors of corners and e_g those of g on each axis, G >= |g|. Since e is off by 5.01 u' of
// itself, d1 is off by 7.2 u' G + 1.42 e_g on each axis, and d2 by 17.3 u' G + 2.02 e_g. The factors of d1 and d2 are
// at most 2 |sin|, and off by 32 u' (1 + k) |sin|. The glide m is off by e_m, and its product by u' s |m| more. Three
// sums and the products add 4.1 u' of all terms. So x is off by
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

// TurnOfPoints describes the turn of rounded corners: the pivot at time 0 and its glide, with upper bounds of their
// errors on any axis. `angles` must outlive users of this struct.
struct TurnOfPoints {
    Point pivot, glide;
    double pivot_error, glide_error;
    const TurnAngles* angles;
};

// TurningPoints holds the rounded corners of both triangles at time 0, and an upper bound of the errors of the corners
// on any axis. The first triangle turns.
struct TurningPoints {
    Points<6> start;
    double start_error;
    TurnOfPoints turn;
};

// TurningSide computes the places of three corners that turn.
class TurningSide {
  public:
    // `underflow` is an upper bound of all lengths whose squares are lost to underflow.
    static constexpr double underflow = 0x1p-500;

    // Takes the three corners in `points` from index `first` on. The caller must call scale() next.
    ECODS_ALWAYS_INLINE TurningSide(const Points<6>& points, std::size_t first, const TurnOfPoints& turn) noexcept
        : turn_(turn) {
        for (std::size_t i = 0; i < 3; ++i) {
            across_[i] = minus(points[first + i], turn.pivot);
            arm_ = std::max(arm_, sum_of_magnitudes(across_[i]));
        }
    }
    // Return the largest of the given numbers, and the largest of the numbers computed at any time.
    ECODS_ALWAYS_INLINE double largest_given() const noexcept {
        return std::max({turn_.pivot_error, largest(turn_.pivot), largest(turn_.glide)});
    }
    ECODS_ALWAYS_INLINE double size() const noexcept { return std::max(largest(turn_.glide), arm_); }
    ECODS_ALWAYS_INLINE const TurnAngles& angles() const noexcept { return *turn_.angles; }
    // Returns true if the error bounds hold for the turn.
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return angles().is_bounded(); }

    // Multiplies all lengths by a power of two. `start_error` is the error bound of the scaled corners.
    ECODS_ALWAYS_INLINE void scale(double scale, double start_error) noexcept {
        double radius = 0;
        glide_ = times(turn_.glide, scale);
        arm_ *= scale;
        glide_error_ = scale * turn_.glide_error;
        arm_error_ = start_error + (scale * turn_.pivot_error + 2 * two_u * arm_);
        for (std::size_t i = 0; i < 3; ++i) {
            across_[i] = cross(angles().axis(), times(across_[i], scale));
            inwards_[i] = cross(angles().axis(), across_[i]);
            radius = std::max(radius, dot(across_[i], across_[i]));
        }
        // The radius is an upper bound: the error of d1 is at most sqrt(3) (1.42 e_g + 7.2 u' G), which is less than
        // the added terms.
        radius_ = std::sqrt(radius) * (1 + 8 * two_u) + 4 * arm_error_ + 16 * two_u * arm_ + underflow;
        way_ = std::sqrt(dot(glide_, glide_)) * (1 + 8 * two_u) + 2 * glide_error_ + underflow;
    }

    // Moves the corners from their places at time 0 to their places at the time of `half`, and adds the errors of the
    // turn to the factors of the error bound of gaps.
    ECODS_ALWAYS_INLINE void turn(const HalfAngle& half, Points<6>& points, std::size_t first,
                                  Point& error) const noexcept {
        const double turned = 2 * half.sin * half.cos, inward = 2 * half.sin * half.sin, sin = std::abs(half.sin);
        const double is_off = half.condition < TurnAngles::condition_max ? 0 : std::numeric_limits<double>::infinity();
        const double common = 1.125 * (half.time * glide_error_ + 8 * sin * arm_error_) +
                              256 * two_u * (1 + half.condition) * sin * arm_ + is_off;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                points[first + i][k] =
                    ((points[first + i][k] + half.time * glide_[k]) + turned * across_[i][k]) + inward * inwards_[i][k];
            }
            error[k] += common + 32 * two_u * half.time * std::abs(glide_[k]);
        }
    }

    // Return, for each axis, an upper bound of the distance of corners from their straight motion, in a piece of this
    // length in time: margins() from the nearest point of the straight motion, and lags() from its point at the same
    // time. A sagitta is perpendicular to the axis e of the turn, so coordinate k of a vector of this length is at most
    // sqrt(1 - e_k^2) of it; both other coordinates of e are off by 5.01 u' of themselves, or lost if they are below
    // 2^-500. The same bound holds for a chord. A glide that is lost to underflow is below 2^-620.
    ECODS_ALWAYS_INLINE Point margins(const TurnPiece& piece, double length) const noexcept {
        Point result;
        for (std::size_t k = 0; k < 3; ++k) {
            const double way = std::abs(glide_[k]) + 2 * glide_error_;
            result[k] =
                (radius_ * piece.sagitta * across(k) + way * length * piece.shift) * (1 + 16 * two_u) + underflow;
        }
        return result;
    }
    ECODS_ALWAYS_INLINE Point lags(const TurnPiece& piece) const noexcept {
        Point result;
        for (std::size_t k = 0; k < 3; ++k) {
            result[k] = radius_ * piece.lag() * across(k) * (1 + 16 * two_u) + underflow;
        }
        return result;
    }
    // Returns an upper bound of the way that a corner goes from the time of `half` to any time at most `span` from that
    // time.
    ECODS_ALWAYS_INLINE double way(const HalfAngle& half, double span) const noexcept {
        return 1.0625 * span * (way_ + 2 * radius_ * angles().speed(half, span)) + underflow;
    }

  private:
    ECODS_ALWAYS_INLINE double across(std::size_t k) const noexcept {
        const Point& e = angles().axis();
        const double x = e[(k + 1) % 3], y = e[(k + 2) % 3];
        return std::sqrt(x * x + y * y) * (1 + 16 * two_u) + 0x1p-499;
    }

    const TurnOfPoints& turn_;
    std::array<Point, 3> across_, inwards_;  // d1 and d2; g before scale()
    Point glide_{};
    double arm_ = 0;                          // G
    double arm_error_ = 0, glide_error_ = 0;  // e_g, e_m
    double radius_ = 0, way_ = 0;             // upper bounds of the distance from the axis, and of |m|
};

// StartCorners holds six corners at time 0, relative to the first one, because the others are near it.
class StartCorners {
  public:
    ECODS_ALWAYS_INLINE StartCorners(const Points<6>& start, double start_error) noexcept
        : error_(start_error), largest_given_(start_error) {
        for (std::size_t i = 0; i < 6; ++i) {
            largest_given_ = std::max(largest_given_, largest(start[i]));
            points_[i] = minus(start[i], start[0]);
            for (std::size_t k = 0; k < 3; ++k) most_[k] = std::max(most_[k], std::abs(points_[i][k]));
        }
    }
    ECODS_ALWAYS_INLINE double largest_given() const noexcept { return largest_given_; }
    ECODS_ALWAYS_INLINE double size() const noexcept { return largest(most_); }

    // Scales the corners, and the sides that move, so that the largest length is about 1. Returns false if the error
    // bounds do not hold.
    template <class... Side>
    ECODS_ALWAYS_INLINE bool scale(Side&... sides) noexcept {
        const double given = std::max({largest_given_, sides.largest_given()...});
        const double size = std::max({largest(most_), sides.size()...});
        const double scale = MovingCorners::inverse_power(size);
        for (Point& p : points_) p = times(p, scale);
        most_ = times(most_, scale);
        error_ *= scale;
        (sides.scale(scale, error_), ...);
        return given < 0x1p1000 && size > 0x1p-400 && (sides.is_bounded() && ...);
    }

    const Points<6>& points() const noexcept { return points_; }
    // Returns the factors of the error bound of gaps, as in MovingCorners::error_at(), for corners at rest.
    ECODS_ALWAYS_INLINE Point errors() const noexcept {
        Point result;
        for (std::size_t k = 0; k < 3; ++k) result[k] = 1.125 * 2 * error_ + 32 * two_u * most_[k];
        return result;
    }

  private:
    Points<6> points_;
    Point most_{};
    double error_, largest_given_;  // e_p
};

class TurningCorners {
  public:
    ECODS_ALWAYS_INLINE explicit TurningCorners(const TurningPoints& points) noexcept
        : start_(points.start, points.start_error), side_(points.start, 0, points.turn) {
        is_bounded_ = start_.scale(side_);
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
        At result{side_.angles().at(s), start_.points(), start_.errors()};
        side_.turn(result.half, result.points, 0, result.error);
        return result;
    }

    ECODS_ALWAYS_INLINE TurnPiece piece(const At& from, const At& to) const noexcept {
        return side_.angles().piece(from.half, to.half);
    }
    // The next functions have the contracts of the functions with the same names in TurningSide.
    ECODS_ALWAYS_INLINE Point margins(const TurnPiece& piece, double length) const noexcept {
        return side_.margins(piece, length);
    }
    ECODS_ALWAYS_INLINE double way(const At& at, double span) const noexcept { return side_.way(at.half, span); }

  private:
    StartCorners start_;
    TurningSide side_;
    bool is_bounded_;
};

}  // namespace ecods::exact
