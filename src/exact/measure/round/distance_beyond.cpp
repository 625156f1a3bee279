#include "exact/measure/round/distance_beyond.hpp"

#include "base/outward.hpp"
#include "exact/measure/round/round_root_sum.hpp"

namespace ecods::exact {

// Returns the sign of distance - sum. The distance is first compared with the doubles around the sum. If the doubles do
// not decide, N 4^f is compared with Q m^2 4^e, where the square of the distance is N / Q 4^f and the sum is m 2^e.
int compare(const SquaredDistance& square, const ExactSum& sum) {
    if (sum.is_double()) return compare(square, sum.lower());
    if (compare(square, sum.lower()) <= 0) return -1;
    if (magnitude_of(sum.upper()) != double_infinity_magnitude && compare(square, sum.upper()) >= 0) return 1;
    const ScaledInteger scaled = sum.scaled();
    return compare_shifted(square.num.limbs(), 2 * (square.exponent - scaled.e()),
                           (scaled.m() * scaled.m() * Integer(square.den.limbs(), false)).limbs());
}

namespace {

RootSum beyond(const SquaredDistance& square, const ExactSum& margin) {
    const ScaledInteger scaled = margin.scaled();
    RootSum difference;
    difference.x = -scaled.m();
    difference.e = scaled.e();
    difference.y = Integer(square.num.limbs(), false);
    difference.w = Integer(square.den.limbs(), false);
    difference.f = square.exponent;
    return difference;
}

}  // namespace

double round_beyond(const SquaredDistance& square, const ExactSum& margin) {
    if (margin.sign() == 0) return round_root(square);
    if (compare(square, margin.lower()) <= 0) return 0;
    return round_positive_part(beyond(square, margin));
}

double round_signed_beyond(const SquaredDistance& square, const ExactSum& margin) {
    return margin.sign() == 0 ? round_root(square) : round_signed(beyond(square, margin));
}

}  // namespace ecods::exact
