#include "exact/measure/round/natural_sum.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/assert.hpp"
#include "exact/measure/round/fraction.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

// A sum has at most sum_limbs limbs. It must hold the terms of a point (exact_point.hpp): the terms of R v + t times a
// denominator, and numerators. All terms are multiples of 2^-2148 below 2^2050 times the denominator: limb_count_max
// limbs more than the denominator has, and a bit for the sign. It must also hold the terms of a point on a line
// (fraction.hpp), which are products of a double, a multiple of 2^-1074 below 2^1024, and a number of fraction_limbs.
constexpr std::size_t sum_limbs = 5 * limb_count_max + 2;
static_assert(fraction_limbs + (1074 + 1024 + 8) / 64 + 2 <= sum_limbs);

// A NaturalSum holds a sum of products, in two's complement.
class NaturalSum {
  public:
    // Makes an empty sum. At most 64 terms may be added, each a multiple of 2^low and below 2^high in magnitude.
    NaturalSum(int low, int high) noexcept : low_(low), size_(static_cast<std::size_t>(high - low + 8) / 64 + 1) {
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

    // Returns the sum divided by `den`, rounded once. Call this function only once, because it overwrites the sum.
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

}  // namespace

double round_sum(std::span<const Summand> terms, NaturalSpan den) noexcept {
    BitRange range;
    for (const Summand& x : terms) {
        if (!x.a.empty() && !x.b.empty()) range.include(x.e, x.e + bit_width(x.a) + bit_width(x.b));
    }
    if (range.empty()) return 0;
    NaturalSum sum(range.low, range.high);
    for (const Summand& x : terms) {
        if (x.a.empty() || x.b.empty()) continue;
        Natural<sum_limbs> product;
        product.assign_product(x.a, x.b);
        sum.add(product.limbs(), x.e, x.is_negative);
    }
    return sum.over(den);
}

}  // namespace ecods::exact
