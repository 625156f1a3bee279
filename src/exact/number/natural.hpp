// A Natural is a natural number of any length up to a capacity; the least significant limb is first. An operation takes
// time for the limbs in use only.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "base/assert.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

// A NaturalSpan refers to the limbs of a natural number without its leading zero limbs; zero has no limbs.
using NaturalSpan = std::span<const std::uint64_t>;

inline NaturalSpan without_leading_zeros(NaturalSpan limbs) noexcept {
    std::size_t size = limbs.size();
    while (size > 0 && limbs[size - 1] == 0) --size;
    return limbs.first(size);
}

inline int bit_width(NaturalSpan a) noexcept {
    return a.empty() ? 0 : static_cast<int>(64 * a.size()) - std::countl_zero(a.back());
}

// Sets `product` to a * b, which has a.size() + b.size() limbs.
inline void multiply(NaturalSpan a, NaturalSpan b, std::uint64_t* product) noexcept {
    std::fill_n(product, a.size() + b.size(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Uint128 p = Uint128{a[i]} * b[j] + product[i + j] + carry;
            product[i + j] = static_cast<std::uint64_t>(p);
            carry = static_cast<std::uint64_t>(p >> 64);
        }
        product[i + b.size()] = carry;
    }
}

template <std::size_t capacity>
class Natural {
  public:
    Natural() noexcept = default;
    explicit Natural(std::uint64_t x) noexcept { assign({&x, 1}); }
    // Copies only the limbs in use.
    Natural(const Natural& other) noexcept { assign(other.limbs()); }
    Natural& operator=(const Natural& other) noexcept {
        if (this != &other) assign(other.limbs());
        return *this;
    }

    void assign(NaturalSpan limbs) noexcept {
        const NaturalSpan used = without_leading_zeros(limbs);
        ECODS_ASSERT(used.size() <= capacity);
        size_ = used.size();
        std::copy(used.begin(), used.end(), limbs_.begin());
    }

    void assign_product(NaturalSpan a, NaturalSpan b) noexcept {
        ECODS_ASSERT(a.size() + b.size() <= capacity);
        multiply(a, b, limbs_.data());
        size_ = without_leading_zeros({limbs_.data(), a.size() + b.size()}).size();
    }

    NaturalSpan limbs() const noexcept { return {limbs_.data(), size_}; }
    bool is_zero() const noexcept { return size_ == 0; }

  private:
    std::size_t size_ = 0;
    std::array<std::uint64_t, capacity> limbs_;
};

// Returns limb i of a * 2^shift; shift must be >= 0.
inline std::uint64_t limb_of_shifted(NaturalSpan a, int shift, std::size_t i) noexcept {
    const std::size_t skip = static_cast<std::size_t>(shift) / 64;
    const int bits = shift % 64;
    const auto limb = [&](std::size_t k) { return k < a.size() ? a[k] : 0; };
    if (i < skip) return 0;
    const std::uint64_t high = limb(i - skip) << bits;
    return bits == 0 || i == skip ? high : high | limb(i - skip - 1) >> (64 - bits);
}

// Returns the sign of a * 2^shift - b; shift may be negative.
inline int compare_shifted(NaturalSpan a, int shift, NaturalSpan b) noexcept {
    if (a.empty() || b.empty()) return static_cast<int>(!a.empty()) - static_cast<int>(!b.empty());
    const int width_a = bit_width(a) + shift, width_b = bit_width(b);
    if (width_a != width_b) return width_a < width_b ? -1 : 1;
    const int shift_a = std::max(shift, 0), shift_b = std::max(-shift, 0);
    for (std::size_t i = static_cast<std::size_t>(width_b + shift_b + 63) / 64; i-- > 0;) {
        const std::uint64_t x = limb_of_shifted(a, shift_a, i), y = limb_of_shifted(b, shift_b, i);
        if (x != y) return x < y ? -1 : 1;
    }
    return 0;
}

}  // namespace ecods::exact
