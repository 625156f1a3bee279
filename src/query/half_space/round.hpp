// Rounds numbers of half spaces once: distances from a plane, feet of perpendiculars, and quotients.
#pragma once

#include "ecods/pose.hpp"
#include "exact/measure/round/fraction.hpp"
#include "exact/number/long_vector.hpp"
#include "query/half_space/heights.hpp"

namespace ecods::half_spaces {

// Returns length / sqrt(square) + more, rounded once; at least 2^-1074 in magnitude unless it is 0. square must be
// positive, and a sum of squares, so that its exponent is even. Heights are polynomials of degree 5 in doubles, so
// their digits are from 2^-5370 to below 2^5130; squares of normals have degree 6, and those of two half spaces 12,
// with fewer than divisor_limbs limbs.
double round_ratio(const exact::ScaledInteger& length, const exact::ScaledInteger& square,
                   const exact::ScaledInteger& more = {});

// Returns the sign of length / sqrt(square) - d. length and d must be >= 0.
int compare_ratio(const exact::ScaledInteger& length, const exact::ScaledInteger& square,
                  const exact::ScaledInteger& d);

// Returns num / den, rounded once; a zero is +0. den must not be 0, and must have at most divisor_limbs limbs.
double round_quotient(const exact::ScaledInteger& num, const exact::ScaledInteger& den);

// Return the given point, the foot of its perpendicular on the plane, or the lowest point of a ball around it, with
// each coordinate rounded once. `height` is the height of the point.
Vec3 round_point(const exact::ScaledLongVector& point);
Vec3 round_foot(const exact::ScaledLongVector& point, const exact::ScaledInteger& height, const Plane& plane);
Vec3 round_lowest(const exact::ScaledLongVector& center, const exact::ScaledInteger& radius, const Plane& plane);

// Returns -N / |N|, with each coordinate rounded once.
Vec3 round_inward(const Plane& plane);

// A Quotient is a quotient of two numbers of one sign, or of 0 and another number.
class Quotient {
  public:
    Quotient(const exact::ScaledInteger& num, const exact::ScaledInteger& den);

    exact::FractionRef ref() const noexcept { return {num_.limbs(), den_.limbs()}; }

  private:
    exact::Integer num_, den_;
};

}  // namespace ecods::half_spaces
