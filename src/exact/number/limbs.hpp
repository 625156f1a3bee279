// Limbs and Magnitude are integers of a fixed number of 64-bit limbs. The least significant limb is first.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/assert.hpp"

namespace ecods::exact {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Uint128;

// bit_width and trailing_zeros are std::bit_width and std::countr_zero for 128 bits, which the standard functions need
// not support. trailing_zeros must not be called for zero.
constexpr int bit_width(Uint128 x) noexcept {
    const auto high = static_cast<std::uint64_t>(x >> 64);
    return static_cast<int>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(static_cast<std::uint64_t>(x)));
}
constexpr int trailing_zeros(Uint128 x) noexcept {
    ECODS_ASSERT(x > 0);
    const auto low = static_cast<std::uint64_t>(x);
    return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(x >> 64));
}

constexpr Uint128 size_of(Int128 x) noexcept {
    return x < 0 ? -static_cast<Uint128>(x) : static_cast<Uint128>(x);
}

inline constexpr std::uint64_t all_ones = ~std::uint64_t{0};

// Limbs<L> is an integer of L limbs in two's complement.
template <int L>
using Limbs = std::array<std::uint64_t, static_cast<std::size_t>(L)>;

// Magnitude<L> is an integer as sign and magnitude. `negative` is 0 or all_ones, and serves as a bit mask; for the
// number zero, `negative` may be either.
template <int L>
struct Magnitude {
    Limbs<L> limbs;
    std::uint64_t negative;
};

template <int L>
inline Limbs<L> subtract(const Limbs<L>& a, const Limbs<L>& b) noexcept {
    Limbs<L> result;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < L; ++i) {
        const Uint128 difference = Uint128{a[i]} - b[i] - borrow;
        result[i] = static_cast<std::uint64_t>(difference);
        borrow = static_cast<std::uint64_t>(difference >> 64) & 1;
    }
    return result;
}

// Adds `addend` to `sum`, or subtracts it if `negative` is all_ones. A number is subtracted by adding its complement
// plus one.
template <int L>
inline void add_signed(Limbs<L>& sum, const Limbs<L>& addend, std::uint64_t negative) noexcept {
    std::uint64_t carry = negative & 1;
    for (std::size_t i = 0; i < L; ++i) {
        const Uint128 s = Uint128{sum[i]} + (addend[i] ^ negative) + carry;
        sum[i] = static_cast<std::uint64_t>(s);
        carry = static_cast<std::uint64_t>(s >> 64);
    }
}

template <int L>
inline Magnitude<L> magnitude(const Limbs<L>& a) noexcept {
    Magnitude<L> result{{}, (a[L - 1] >> 63) ? all_ones : 0};
    add_signed<L>(result.limbs, a, result.negative);
    return result;
}

// inlined_products_max is the greatest number of pairs of limbs of a product that is inlined. Longer products, inlined
// and unrolled at each call, were a tenth of the library's code and of its compile time.
inline constexpr int inlined_products_max = 16;

template <int A, int B>
inline void multiply_into(Limbs<A + B>& product, const Limbs<A>& a, const Limbs<B>& b) noexcept {
    for (std::size_t i = 0; i < A; ++i) {
        if (A > 4 && a[i] == 0) continue;
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < B; ++j) {
            const Uint128 p = Uint128{a[i]} * b[j] + product[i + j] + carry;
            product[i + j] = static_cast<std::uint64_t>(p);
            carry = static_cast<std::uint64_t>(p >> 64);
        }
        product[i + B] = carry;
    }
}
template <int A, int B>
[[gnu::noinline]] void multiply_out_of_line(Limbs<A + B>& product, const Limbs<A>& a, const Limbs<B>& b) noexcept {
    multiply_into<A, B>(product, a, b);
}

// Returns a * b, which always fits. If `a` has more than four limbs, its zero limbs are skipped, because long numbers
// often have leading zeros.
template <int A, int B>
inline Limbs<A + B> multiply(const Limbs<A>& a, const Limbs<B>& b) noexcept {
    Limbs<A + B> product{};
    if constexpr (A * B > inlined_products_max) {
        multiply_out_of_line<A, B>(product, a, b);
    } else {
        multiply_into<A, B>(product, a, b);
    }
    return product;
}

template <int L>
inline bool is_zero(const Limbs<L>& a) noexcept {
    std::uint64_t any = 0;
    for (const std::uint64_t limb : a) any |= limb;
    return any == 0;
}

// Returns the sign of a: -1, 0 or 1.
template <int L>
inline int sign(const Limbs<L>& a) noexcept {
    return (a[L - 1] >> 63) ? -1 : !is_zero<L>(a);
}

template <int L>
inline int sign(const Magnitude<L>& a) noexcept {
    return is_zero<L>(a.limbs) ? 0 : a.negative ? -1 : 1;
}

inline int sign(Int128 a) noexcept {
    return (a > 0) - (a < 0);
}

// Int256 is an integer of 256 bits in two's complement.
struct Int256 {
    Uint128 low;
    Int128 high;
};

inline Int256 operator+(const Int256& a, const Int256& b) noexcept {
    const Uint128 low = a.low + b.low;
    return {low, static_cast<Int128>(static_cast<Uint128>(a.high) + static_cast<Uint128>(b.high) + (low < a.low))};
}

inline Int256 operator-(const Int256& a, const Int256& b) noexcept {
    const Uint128 low = a.low - b.low;
    return {low, static_cast<Int128>(static_cast<Uint128>(a.high) - static_cast<Uint128>(b.high) - (a.low < b.low))};
}

inline int sign(const Int256& a) noexcept {
    return a.high < 0 ? -1 : a.high != 0 || a.low != 0;
}

// high_word and low_word return the two words of an integer of two words. widened extends an integer of one word to
// two, with its sign.
inline std::int64_t high_word(Int128 x) noexcept {
    return static_cast<std::int64_t>(x >> 64);
}
inline std::uint64_t low_word(Int128 x) noexcept {
    return static_cast<std::uint64_t>(x);
}
inline Int128 widened(std::int64_t x) noexcept {
    return x;
}
inline Int128 high_word(const Int256& x) noexcept {
    return x.high;
}
inline Uint128 low_word(const Int256& x) noexcept {
    return x.low;
}
inline Int256 widened(Int128 x) noexcept {
    return {static_cast<Uint128>(x), x >> 127};
}

inline Int128 multiply(std::int64_t a, std::int64_t b) noexcept {
    return Int128{a} * b;
}
// Returns a * b. The signed multiplication reads b as b - 2^64 if b's top bit is set; then a * 2^64 is added.
inline Int128 multiply_unsigned(std::int64_t a, std::uint64_t b) noexcept {
    const auto top = static_cast<std::uint64_t>(static_cast<std::int64_t>(b) >> 63);  // all ones if b's top bit is set
    const std::uint64_t missing = static_cast<std::uint64_t>(a) & top;
    return static_cast<Int128>(static_cast<Uint128>(Int128{a} * static_cast<std::int64_t>(b)) +
                               (Uint128{missing} << 64));
}

// Returns a * b for unsigned a and b, from products of their 64-bit halves.
inline Int256 multiply_halves(Uint128 a, Uint128 b) noexcept {
    const auto a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
    const auto b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64);
    const Uint128 p00 = Uint128{a0} * b0, p01 = Uint128{a0} * b1, p10 = Uint128{a1} * b0, p11 = Uint128{a1} * b1;
    const Uint128 middle = (p00 >> 64) + static_cast<std::uint64_t>(p01) + static_cast<std::uint64_t>(p10);
    return {middle << 64 | static_cast<std::uint64_t>(p00),
            static_cast<Int128>(p11 + (p01 >> 64) + (p10 >> 64) + (middle >> 64))};
}

// Returns a * b. If a is negative, the unsigned multiplication reads it as a + 2^128; then 2^128 b is subtracted.
inline Int256 multiply_unsigned(Int128 a, Uint128 b) noexcept {
    Int256 p = multiply_halves(static_cast<Uint128>(a), b);
    p.high = static_cast<Int128>(static_cast<Uint128>(p.high) - (static_cast<Uint128>(a >> 127) & b));
    return p;
}

inline Int256 multiply(Int128 a, Int128 b) noexcept {
    Int256 p = multiply_unsigned(a, static_cast<Uint128>(b));
    p.high =
        static_cast<Int128>(static_cast<Uint128>(p.high) - (static_cast<Uint128>(b >> 127) & static_cast<Uint128>(a)));
    return p;
}

// Returns limb i of a. Limbs beyond the last one are filled with the sign bit.
inline std::uint64_t limb_at(std::span<const std::uint64_t> a, std::size_t i) noexcept {
    return i < a.size() ? a[i] : (a.back() >> 63) ? all_ones : 0;
}

// Returns a >> shift in M limbs, with the sign extended. The result must fit into M limbs.
template <int M>
inline Limbs<M> shift_right(std::span<const std::uint64_t> a, int shift) noexcept {
    const auto skip = static_cast<std::size_t>(shift) / 64;
    const int bits = shift % 64;
    Limbs<M> result;
    for (std::size_t i = 0; i < M; ++i) {
        const std::uint64_t low = limb_at(a, i + skip);
        const std::uint64_t high = limb_at(a, i + skip + 1);
        result[i] = bits == 0 ? low : (low >> bits) | (high << (64 - bits));
    }
    return result;
}

// Adds term * 2^shift to `sum`. The result must fit.
template <int L>
inline void add_shifted(Limbs<L>& sum, Int128 term, int shift) noexcept {
    ECODS_ASSERT(shift >= 0);
    const int skip = shift / 64;
    const int bits = shift % 64;
    const std::uint64_t low = static_cast<std::uint64_t>(term);
    const std::uint64_t high = static_cast<std::uint64_t>(term >> 64);
    const std::uint64_t rest = term < 0 ? all_ones : 0;
    const std::array<std::uint64_t, 3> digits{low << bits, bits == 0 ? high : (high << bits) | (low >> (64 - bits)),
                                              bits == 0 ? rest : (rest << bits) | (high >> (64 - bits))};
    std::uint64_t carry = 0;
    for (int i = skip; i < L; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const std::uint64_t digit = i - skip < 3 ? digits[static_cast<std::size_t>(i - skip)] : rest;
        const Uint128 s = Uint128{sum[at]} + digit + carry;
        sum[at] = static_cast<std::uint64_t>(s);
        carry = static_cast<std::uint64_t>(s >> 64);
    }
}

}  // namespace ecods::exact
