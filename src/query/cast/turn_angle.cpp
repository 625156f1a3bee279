// This file computes the angle of a turn at a time, the time of an angle, and the turn about an axis by an angle. Each
// result is the real number, rounded once: comparisons are decided in integers, with bounds of sines and cosines that
// are refined until they decide. The refinement ends, because the angle at a rational time is irrational unless it is
// 0: it is twice the angle of a vector with algebraic coordinates (theorem of Lindemann and Weierstrass). Since
// rounding is monotonic, rounded angles do not decrease with time, and rounded times do not decrease with the angle.
#include <array>
#include <cmath>
#include <string>

#include "base/limits.hpp"
#include "exact/number/nearest_double.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/find_invalid.hpp"
#include "query/cast/cosine_bounds.hpp"
#include "query/cast/exact_turn.hpp"

namespace ecods {
namespace {

using exact::binary_fraction;
using exact::BinaryFraction;
using exact::Integer;
using exact::nearest_double;

constexpr double two_pi_above = 0x1.921fb54442d19p+2;  // the least double above 2 pi
constexpr double rounded_max = 8;                      // upper bound of all numbers that are rounded here

Integer magnitude_of(const Integer& x) {
    return x.sign() < 0 ? -x : x;
}

// Returns the sign of X^2 u - Y^2 v for all X within `off` of |x| and all Y within `off` of |y|; 0 if that is not
// certain.
int compare_squares(const Integer& x, const Integer& u, const Integer& y, const Integer& v, const Integer& off) {
    const auto square = [](const Integer& a) { return a * a; };
    const Integer size_x = magnitude_of(x), size_y = magnitude_of(y);
    const auto low = [&](const Integer& size) { return compare(size, off) <= 0 ? Integer() : square(size - off); };
    if (compare(low(size_x) * u, square(size_y + off) * v) > 0) return 1;
    if (compare(square(size_x + off) * u, low(size_y) * v) < 0) return -1;
    return 0;
}

// Returns the sign of (angle of `turn`) - `angle`, for 0 <= angle < 6.3. Let f in [0, pi) be half the angle of the
// turn, which the vector (a, b |v|) has, and t = angle / 2. Then sin(f - t) has the sign of b |v| cos t - a sin t.
int compare_angle(const ExactTurn& turn, const BinaryFraction& angle) {
    const Integer size = exact::dot(turn.v, turn.v), bb = turn.b * turn.b, aa = turn.a * turn.a;
    if (turn.b.is_zero() || size.is_zero()) return angle.m.is_zero() ? 0 : -1;
    if (angle.m.is_zero()) return 1;
    const BinaryFraction t{angle.m, angle.bits + 1};
    if (turn.a.sign() >= 0 && compare(t.m, Integer(std::int64_t{2}) << t.bits) > 0) return -1;  // f <= pi / 2 < 2 < t
    return decide_by_cosine(t, [&](const CosineBounds& at) {
        const bool is_certain = compare(magnitude_of(at.cos), at.off) > 0 && compare(magnitude_of(at.sin), at.off) > 0;
        if (!is_certain) return 0;
        const int first = at.cos.sign(), second = turn.a.sign() * at.sin.sign();
        if (first != second) return first - second > 0 ? 1 : -1;
        return first * compare_squares(at.cos, bb * size, at.sin, aa, at.off);
    });
}

// Returns the double nearest to the angle of the turn at a time, given a guess of the angle.
double angle_nearest_to(const Turn& turn, double time) {
    const Quaternion& q = turn.q;
    const double size = std::hypot(q.x, q.y, q.z);
    const double guess = 2 * std::atan2(time * size, (1 - time) + time * q.w);
    const ExactTurn at(q, binary_fraction(time));
    return nearest_double(
        guess, [&](const BinaryFraction& m) { return compare_angle(at, m); }, rounded_max);
}

void require_time_of_turn(double time) {
    if (!is_from_zero(time) || key_of(time) > key_of(1.0)) throw invalid_time(time);
}

// Returns |cos t| or |sin t|, times sqrt(square / all), rounded once. t is positive.
double rounded_product(const BinaryFraction& t, bool is_sine, const Integer& square, const Integer& all, double guess) {
    if (square.is_zero()) return 0;
    const auto compare_magnitude = [&](const BinaryFraction& m) {
        return decide_by_cosine(t, [&](const CosineBounds& bounds) {
            // Compares (value / scale)^2 square / all with (m / 2^bits)^2, where `value` is the cosine or the sine.
            const Integer& value = is_sine ? bounds.sin : bounds.cos;
            const Integer size = magnitude_of(value) << m.bits, off = bounds.off << m.bits;
            const Integer other = m.m * bounds.scale;
            const auto compare_with = [&](const Integer& x) {
                return x.sign() <= 0 ? -1 : compare((x * x) * square, (other * other) * all);
            };
            if (compare_with(size - off) > 0) return 1;
            return compare_with(size + off) < 0 ? -1 : 0;
        });
    };
    return nearest_double(guess, compare_magnitude, rounded_max);
}

}  // namespace

double angle_at(const Turn& turn, double time) {
    validate(turn);
    require_time_of_turn(time);
    return angle_nearest_to(turn, time);
}

double time_at(const Turn& turn, double angle) {
    validate(turn);
    if (!is_from_zero(angle)) throw invalid_turn("angle", angle);
    if (key_of(angle) == 0) return 0;
    const BinaryFraction one{Integer(std::int64_t{1}), 0};
    if (key_of(angle) >= key_of(two_pi_above)) return 1;
    const BinaryFraction given = binary_fraction(angle);
    if (compare_angle(ExactTurn(turn.q, one), given) <= 0) return 1;
    const Quaternion& q = turn.q;
    const double size = std::hypot(q.x, q.y, q.z), half = 0.5 * angle;
    const double guess = std::sin(half) / ((1 - q.w) * std::sin(half) + size * std::cos(half));
    const auto compare_with = [&](const BinaryFraction& m) { return -compare_angle(ExactTurn(q, m), given); };
    return nearest_double(guess, compare_with, rounded_max);
}

Turn about(const Vec3& axis, double angle, const Vec3& pivot) {
    for (int k = 0; k < 3; ++k) {
        if (!is_finite(axis[k])) throw invalid_turn("axis(" + std::to_string(k) + ")", axis[k]);
    }
    for (int k = 0; k < 3; ++k) {
        if (!is_finite(pivot[k])) throw invalid_turn("pivot(" + std::to_string(k) + ")", pivot[k]);
    }
    if (is_zero(axis)) throw invalid_turn("axis", 0);
    const double size = std::abs(angle);
    if (!is_finite(angle) || key_of(size) >= key_of(two_pi_above)) throw invalid_turn("angle", angle);
    if (key_of(size) == 0) return {{}, pivot, pivot};
    const BinaryFraction given = binary_fraction(size), t{given.m, given.bits + 1};
    const double half = 0.5 * size;  // for guesses
    const exact::TurnIntegers integers(1, axis);
    const Integer one(std::int64_t{1}), all = exact::dot(integers.v, integers.v);
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    Turn result{{}, pivot, pivot};
    const double w = rounded_product(t, false, one, one, std::abs(std::cos(half)));
    const bool is_obtuse = compare_angle(ExactTurn({0, 1, 0, 0}, {one, 0}), given) < 0;
    result.q.w = is_obtuse ? -w : w;
    std::array<double, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
        const double part = axis[static_cast<Eigen::Index>(k)];
        v[k] = rounded_product(t, true, integers.v[k] * integers.v[k], all, std::abs(std::sin(half) * (part / length)));
        if ((key_of(part) < 0) != (key_of(angle) < 0)) v[k] = opposite(v[k]);
    }
    result.q.x = v[0];
    result.q.y = v[1];
    result.q.z = v[2];
    return result;
}

}  // namespace ecods
