#include "exact/measure/exact_point.hpp"

#include <algorithm>
#include <cstdint>

#include "base/assert.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

// A term of a coordinate: size * 2^e.
struct Term {
    std::array<std::uint64_t, 2> limbs;
    int e;
    bool is_negative;
};

Term product(const Dyadic& a, const Dyadic& b) noexcept {
    const Uint128 size = Uint128{magnitude(a.m)} * magnitude(b.m);
    return {
        {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)}, a.e + b.e, (a.m < 0) != (b.m < 0)};
}

// A sum of numbers, in two's complement. Terms times a denominator are below 2^2050 times it and multiples of 2^-2148,
// and so are numerators: limb_count_max limbs for what the denominator is multiplied by, and a bit for the sign.
constexpr std::size_t sum_limbs = 5 * limb_count_max + 2;

class Sum {
  public:
    // Of multiples of 2^low below 2^high.
    Sum(int low, int high) noexcept : low_(low), size_(static_cast<std::size_t>(high - low + 8) / 64 + 1) {
        ECODS_ASSERT(size_ <= sum_limbs);
        std::fill_n(limbs_.begin(), size_, 0);
    }

    void add(NaturalSpan a, int e, bool negative) noexcept {
        const int shift = e - low_;
        const std::uint64_t flip = negative ? all_ones : 0;
        std::uint64_t carry = negative ? 1 : 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const Uint128 s = Uint128{limbs_[i]} + (limb_of_shifted(a, shift, i) ^ flip) + carry;
            limbs_[i] = static_cast<std::uint64_t>(s);
            carry = static_cast<std::uint64_t>(s >> 64);
        }
    }

    // The double nearest to the sum over `den`.
    double over(NaturalSpan den) noexcept {
        const bool is_negative = (limbs_[size_ - 1] >> 63) != 0;
        if (is_negative) {
            std::uint64_t carry = 1;
            for (std::size_t i = 0; i < size_; ++i) {
                limbs_[i] = ~limbs_[i] + carry;
                carry &= static_cast<std::uint64_t>(limbs_[i] == 0);
            }
        }
        return round_quotient(without_leading_zeros({limbs_.data(), size_}), den, low_, is_negative);
    }

  private:
    int low_;
    std::size_t size_;
    std::array<std::uint64_t, sum_limbs> limbs_;
};

double round_coordinate(const PointRef& origin, int row, const ExactPoint& point) noexcept {
    const Dyadic one{1, 0};
    std::array<Term, 4> terms;
    for (int k = 0; k < 3; ++k) {
        terms[static_cast<std::size_t>(k)] = product(decode(origin.pose->R(row, k)), decode((*origin.v)[k]));
    }
    terms[3] = product(decode(origin.pose->t[row]), one);

    const ExactPoint::Coordinate& num = point.num[static_cast<std::size_t>(row)];
    const NaturalSpan den = point.den.limbs();
    BitRange range;
    if (!num.size.is_zero()) range.include(point.unit, point.unit + bit_width(num.size.limbs()));
    for (const Term& term : terms) {
        const int width = bit_width(without_leading_zeros(term.limbs));
        if (width > 0) range.include(term.e, term.e + width + bit_width(den));
    }
    if (range.empty()) return 0;
    Sum sum(range.low, range.high);
    if (!num.size.is_zero()) sum.add(num.size.limbs(), point.unit, num.is_negative);
    for (const Term& term : terms) {
        const NaturalSpan limbs = without_leading_zeros(term.limbs);
        if (limbs.empty()) continue;
        Natural<denominator_limbs + 2> times_den;
        times_den.assign_product(den, limbs);
        sum.add(times_den.limbs(), term.e, term.is_negative);
    }
    return sum.over(den);
}

}  // namespace

Vec3 round_point(const PointRef& origin, const ExactPoint& point) noexcept {
    Vec3 result;
    for (int row = 0; row < 3; ++row) result[row] = round_coordinate(origin, row, point);
    return result;
}

}  // namespace ecods::exact
