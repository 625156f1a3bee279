#include "exact/measure/round/squared_distance.hpp"

#include "base/outward.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

int compare(const SquaredDistance& square, double d) noexcept {
    if (magnitude_of(d) == double_infinity_magnitude) return -1;
    const Dyadic x = decode(d);
    const Uint128 xx = Uint128{magnitude(x.m)} * magnitude(x.m);
    const std::array<std::uint64_t, 2> limbs{static_cast<std::uint64_t>(xx), static_cast<std::uint64_t>(xx >> 64)};
    Natural<denominator_limbs + 2> other;
    other.assign_product(square.den.limbs(), without_leading_zeros(limbs));
    return compare_shifted(square.num.limbs(), 2 * (square.exponent - x.e), other.limbs());
}

int compare(const SquaredDistance& first, const SquaredDistance& second) noexcept {
    Natural<numerator_limbs + denominator_limbs> a, b;
    a.assign_product(first.num.limbs(), second.den.limbs());
    b.assign_product(second.num.limbs(), first.den.limbs());
    return compare_shifted(a.limbs(), 2 * (first.exponent - second.exponent), b.limbs());
}

}  // namespace ecods::exact
