// Integers of a fixed number of 64-bit limbs, least significant first.
#pragma once

#include <array>
#include <cstdint>

namespace ecods::exact {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Uint128;

inline constexpr std::uint64_t all_ones = ~std::uint64_t{0};

// Two's complement.
template <int L>
using Limbs = std::array<std::uint64_t, static_cast<std::size_t>(L)>;

// Sign and magnitude. `negative` is 0 or all_ones, so that it can be used as a mask; zero may have either.
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

// sum += addend, or sum -= addend where `negative` is all_ones: a negated number is its complement plus one.
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

// a * b, which always fits. Leading zero limbs of wide numbers are common and skipped.
template <int A, int B>
inline Limbs<A + B> multiply(const Limbs<A>& a, const Limbs<B>& b) noexcept {
    Limbs<A + B> product{};
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
    return product;
}

template <int L>
inline bool is_zero(const Limbs<L>& a) noexcept {
    std::uint64_t any = 0;
    for (const std::uint64_t limb : a) any |= limb;
    return any == 0;
}

// -1, 0 or 1.
template <int L>
inline int sign(const Limbs<L>& a) noexcept {
    return (a[L - 1] >> 63) ? -1 : !is_zero<L>(a);
}

template <int L>
inline int sign(const Magnitude<L>& a) noexcept {
    return is_zero<L>(a.limbs) ? 0 : a.negative ? -1 : 1;
}

inline int sign(Int128 a) noexcept { return (a > 0) - (a < 0); }

// The limb at position i of a number that goes on with its sign.
template <int L>
inline std::uint64_t limb_at(const Limbs<L>& a, int i) noexcept {
    return i < L ? a[static_cast<std::size_t>(i)] : (a[L - 1] >> 63) ? all_ones : 0;
}

// Limbs `M` of a >> shift, the sign kept. The result must fit.
template <int M, int L>
inline Limbs<M> shift_right(const Limbs<L>& a, int shift) noexcept {
    const int skip = shift / 64;
    const int bits = shift % 64;
    Limbs<M> result;
    for (int i = 0; i < M; ++i) {
        const std::uint64_t low = limb_at<L>(a, i + skip);
        const std::uint64_t high = limb_at<L>(a, i + skip + 1);
        result[static_cast<std::size_t>(i)] = bits == 0 ? low : (low >> bits) | (high << (64 - bits));
    }
    return result;
}

// sum += term * 2^shift. The result must fit.
template <int L>
inline void add_shifted(Limbs<L>& sum, Int128 term, int shift) noexcept {
    const int skip = shift / 64;
    const int bits = shift % 64;
    const std::uint64_t low = static_cast<std::uint64_t>(term);
    const std::uint64_t high = static_cast<std::uint64_t>(term >> 64);
    const std::uint64_t rest = term < 0 ? all_ones : 0;
    const std::array<std::uint64_t, 3> digits{
        low << bits, bits == 0 ? high : (high << bits) | (low >> (64 - bits)),
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
