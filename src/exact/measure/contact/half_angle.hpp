// TurnAngles computes half the angle by which a body has turned at a time, in doubles with error bounds, in any
// rounding mode.
//
// The quaternion at time s is (a, b e) with a = 1 + s (w - 1), b = s |v| and the axis e = v / |v|. Let h = |(a, b)|,
// cos = a / h and sin = b / h: cosine and sine of half the angle by which the body has turned.
//
// Bound. Let u' = 2^-52. w and the components of v may be off by u' / 2 of themselves: those of a leg of a way are
// rounded once (turn_leg.hpp). So the length |v| is off by 3.5 u' of itself, b by 4.51 u', and e by 5.01 u'. a is off
// by 3.51 u' (1 - s + s |w|). Let k = (1 - s + s |w|) / h, which is at least |cos|. Half the angle, atan2(b, a), is off
// by
//     |cos sin| 4.51 u' + |sin| 3.51 u' k, to first order: below 8.1 u' k |sin| for k u' < 2^-20.
// h, cos and sin as computed from a and b are off by 3.02 u' of themselves. In all, 2 sin cos and 2 sin^2 are off by
// less than u' |sin| (15 + 17 k) each, below 32 u' (1 + k) |sin|.
//
// Underflow. Unless v is zero, the length |v| is between 2^-500 and 2^500, and |w| below 2^500 (otherwise the angles
// are not bounded). So squares neither overflow nor make h zero. Losses of 2^-1022 are below 2^-500 of h.
// Claim: verify/proofs/turn_pieces.md
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "ecods/pose.hpp"
#include "exact/point/point.hpp"
#include "geometry/find_invalid.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// HalfAngle is half the angle of a turn at one time.
struct HalfAngle {
    double time, cos, sin;
    double length;     // h
    double condition;  // k: how much cancellation enlarges the errors
};

// TurnPiece bounds how far a turn between two times is from a straight motion between the same places
// (turning_points.hpp).
struct TurnPiece {
    double sagitta = std::numeric_limits<double>::infinity();  // of a point at distance 1 from the axis
    double chord = 0;                                          // way of such a point on its straight motion
    double shift = 0;                                          // of a pivot that glides by 1 in the piece; below 2^20
    double pace = 0;                                           // least weight, divided by the greatest one

    // Returns an upper bound of the distance of a point at distance 1 from the axis from its straight motion at the
    // same part of the piece's time. (The sagitta is the distance from the nearest point of the straight motion.)
    ECODS_ALWAYS_INLINE double lag() const noexcept { return (sagitta + shift * chord) * (1 + 8 * two_u); }

    // Return the least and the greatest part of the piece's time at which the straight motion may have gone the part
    // `way` of its way; both are rounded outwards.
    ECODS_ALWAYS_INLINE double earliest(double way) const noexcept {
        return way > 0 ? (pace * way) / ((1 - way) + pace * way) * (1 - 16 * two_u) : 0;
    }
    ECODS_ALWAYS_INLINE double latest(double way) const noexcept {
        return way < 1 ? way / (way + pace * (1 - way)) * (1 + 16 * two_u) : 1;
    }
};

class TurnAngles {
  public:
    TurnAngles() = default;
    // Takes the quaternion (w, v), which the turn reaches at time 1.
    TurnAngles(double w, const Vec3& v) noexcept : w_(w) {
        length_ = std::sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]);
        if (ecods::is_zero(v)) {
            w_ = 1;  // the motion is the same for every w > 0
            return;
        }
        is_bounded_ = length_ >= 0x1p-500 && length_ <= 0x1p500 && std::abs(w) <= 0x1p500;
        if (is_bounded_) axis_ = {v[0] / length_, v[1] / length_, v[2] / length_};
    }

    bool is_bounded() const noexcept { return is_bounded_; }
    const Point& axis() const noexcept { return axis_; }  // zero if the body only glides

    // Returns an estimate of the greatest condition at any time: for w < 0 the condition is greatest near a = 0, where
    // it is 2 |w| / |v|.
    double condition_limit() const noexcept { return w_ < 0 ? -2 * w_ / length_ : 1; }

    ECODS_ALWAYS_INLINE HalfAngle at(double s) const noexcept {
        const double rest = 1 - s, a = rest + s * w_, b = s * length_;
        const double h = std::sqrt(a * a + b * b);
        return {s, a / h, b / h, h, (rest + s * std::abs(w_)) / h};
    }

    // Returns an upper bound of d (half the angle) / ds = |v| / h^2 at all times that are at most `span` from the time
    // of `half`; infinity if no bound is found. h changes by at most |q - 1| for each unit of time.
    ECODS_ALWAYS_INLINE double speed(const HalfAngle& half, double span) const noexcept {
        const double change = 1.0625 * span * ((std::abs(w_) + 1) + length_), h = half.length;
        if (!(change < 0.25 * h) || !(half.condition < condition_max)) return std::numeric_limits<double>::infinity();
        return 1.0625 * length_ / ((h - change) * (h - change));
    }

    // Returns the bounds of the piece between the times of z0 and z1. The sagitta is infinite if the piece is a third
    // of a turn or more, or if its weights differ by a factor of 2^20.
    //
    // Let z0 and z1 be the quaternions at its ends: w0 = |z0|^2, w1 = z0.z1 and w2 = |z1|^2, here divided by w0. The
    // cosine of half the piece's angle is off by less than off = 32 u' (1 + k0 + k1). Its sine is (a0 b1 - a1 b0) / (h0
    // h1) = |v| (s1 - s0) / (h0 h1): h is off by 3.51 u' k + 7.6 u' of itself, |v| by 3.5 u', and four roundings add
    // 4.1 u', so the sine is off by less than `off` of itself, however small it is. Squares that underflow are below
    // 2^-1000. The quotient of lengths is off by 15 u' (1 + k0 + k1) of itself. With a cosine of at least 1/2, weights
    // are off by less than 8 off of themselves.
    ECODS_ALWAYS_INLINE TurnPiece piece(const HalfAngle& z0, const HalfAngle& z1) const noexcept {
        const double off = 32 * two_u * (1 + z0.condition + z1.condition);
        const double cos = (z0.cos * z1.cos + z0.sin * z1.sin) - off;
        const double sin = length_ * (z1.time - z0.time) / (z0.length * z1.length) * (1 + off);
        if (!(cos >= 0.5) || !(off < 0x1p-14)) return {};  // conditions below condition_max suffice
        const double ratio = z1.length / z0.length;
        const double w1 = ratio * cos, w2 = ratio * ratio;
        const double least = std::min({1.0, w1, w2}), most = std::max({1.0, w1, w2});
        if (!(least > 0x1p-20 * most)) return {};
        TurnPiece result;
        result.sagitta = sin * sin / (1 + cos) * (1 + 16 * two_u) + 0x1p-1000;
        result.chord = 2 * sin * (1 + 8 * two_u) + 0x1p-1000;
        const double step = std::max(std::abs(w1 - 1), std::abs(w2 - w1)) + 16 * off * most;
        result.shift = step / (4 * least) * (1 + 32 * off);
        result.pace = least / most * (1 - 32 * off);
        return result;
    }

    static constexpr double condition_max = 0x1p30;

  private:
    double w_ = 1;
    double length_ = 0;
    Point axis_{};
    bool is_bounded_ = true;
};

}  // namespace ecods::exact
