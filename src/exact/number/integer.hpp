// An Integer is an integer of any length, stored as sign and magnitude. Up to twelve limbs are stored in the object,
// more on the heap. An operation takes time for the limbs in use only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "exact/number/limbs.hpp"
#include "exact/number/natural.hpp"

namespace ecods::exact {

class Integer {
  public:
    Integer() noexcept {}
    Integer(std::int64_t x) noexcept : Integer(Int128{x}) {}
    Integer(Int128 x) noexcept {
        const Uint128 size = size_of(x);
        small_[0] = static_cast<std::uint64_t>(size);
        small_[1] = static_cast<std::uint64_t>(size >> 64);
        size_ = small_[1] != 0 ? 2 : small_[0] != 0 ? 1 : 0;
        is_negative_ = x < 0;
    }
    // Makes the integer with the given magnitude, negated if `is_negative`.
    Integer(NaturalSpan magnitude, bool is_negative) { assign(magnitude, is_negative); }
    // Makes the integer x, given in two's complement.
    template <std::size_t L>
    explicit Integer(const std::array<std::uint64_t, L>& x) {
        const Magnitude<static_cast<int>(L)> m = magnitude<static_cast<int>(L)>(x);
        assign(m.limbs, m.negative != 0);
    }
    Integer(const Integer& other) { assign(other.limbs(), other.is_negative_); }
    Integer(Integer&& other) noexcept { take(other); }
    Integer& operator=(const Integer& other) {
        if (this != &other) assign(other.limbs(), other.is_negative_);
        return *this;
    }
    Integer& operator=(Integer&& other) noexcept {
        if (this != &other) take(other);
        return *this;
    }
    ~Integer() = default;

    // Returns the sign of the integer: -1, 0 or 1.
    int sign() const noexcept { return size_ == 0 ? 0 : is_negative_ ? -1 : 1; }
    bool is_zero() const noexcept { return size_ == 0; }

    // limbs() returns the magnitude without leading zeros, and bit_width() its number of bits. For zero, limbs() is
    // empty and bit_width() is 0.
    NaturalSpan limbs() const noexcept { return {data(), size_}; }
    int bit_width() const noexcept { return exact::bit_width(limbs()); }
    // Returns the number of zero bits at the low end of the magnitude. The integer must not be zero.
    int trailing_zeros() const noexcept;

    Integer operator-() const&;
    Integer operator-() && noexcept {
        is_negative_ = !is_negative_;
        return std::move(*this);
    }
    friend Integer operator+(const Integer& a, const Integer& b) { return sum(a, b, false); }
    friend Integer operator-(const Integer& a, const Integer& b) { return sum(a, b, true); }
    friend Integer operator*(const Integer& a, const Integer& b);

    // Operator << multiplies by 2^bits. Operator >> divides by 2^bits and rounds towards zero.
    friend Integer operator<<(const Integer& a, int bits);
    friend Integer operator>>(const Integer& a, int bits);

    // Returns the sign of a - b.
    friend int compare(const Integer& a, const Integer& b) noexcept;
    friend bool operator==(const Integer& a, const Integer& b) noexcept { return compare(a, b) == 0; }

  private:
    static constexpr std::size_t small_limbs = 12;

    const std::uint64_t* data() const noexcept { return capacity_ == small_limbs ? small_.data() : large_.get(); }
    std::uint64_t* data() noexcept { return capacity_ == small_limbs ? small_.data() : large_.get(); }
    // Allocates space for `size` limbs, whose values are undefined afterwards.
    void reserve(std::size_t size) {
        if (size <= capacity_) return;
        large_ = std::make_unique_for_overwrite<std::uint64_t[]>(size);
        capacity_ = static_cast<std::uint32_t>(size);
    }
    void set_size(std::size_t size) noexcept {
        size_ = static_cast<std::uint32_t>(without_leading_zeros({data(), size}).size());
    }
    void assign(NaturalSpan limbs, bool is_negative) {
        const NaturalSpan used = without_leading_zeros(limbs);
        reserve(used.size());
        std::copy(used.begin(), used.end(), data());
        size_ = static_cast<std::uint32_t>(used.size());
        is_negative_ = is_negative;
    }
    void take(Integer& other) noexcept {
        size_ = other.size_;
        is_negative_ = other.is_negative_;
        capacity_ = other.capacity_;
        if (capacity_ == small_limbs) {
            std::copy_n(other.small_.begin(), size_, small_.begin());
        } else {
            large_ = std::move(other.large_);
        }
        other.size_ = 0;
        other.capacity_ = small_limbs;
    }
    static Integer sum(const Integer& a, const Integer& b, bool negates_b);

    std::uint32_t size_ = 0;
    std::uint32_t capacity_ = small_limbs;  // if greater than small_limbs, the limbs are in large_
    bool is_negative_ = false;              // without meaning for zero
    std::array<std::uint64_t, small_limbs> small_;
    std::unique_ptr<std::uint64_t[]> large_;
};

}  // namespace ecods::exact
