// Sums of natural numbers times powers of two, of either sign.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/assert.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/natural.hpp"

namespace ecods::exact {

// In two's complement, for numbers of up to 64 (limbs - 1) bits and a sign.
template <std::size_t limbs>
class NaturalSum {
  public:
    // Of multiples of 2^low below 2^high, of which there are at most 64.
    NaturalSum(int low, int high) noexcept : low_(low), size_(static_cast<std::size_t>(high - low + 8) / 64 + 1) {
        ECODS_ASSERT(size_ <= limbs);
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

    // The double nearest to the sum over `den`. The sum is lost.
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
    std::array<std::uint64_t, limbs> limbs_;
};

}  // namespace ecods::exact
