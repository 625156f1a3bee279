// Floats is a register of sixteen floats, on processors with AVX-512, often two rows of eight lanes. A Mask has one bit
// for each lane.
//
// This file uses intrinsics and not Vec, because comparisons with AVX-512 give bit masks, and g++ converts masks of Vec
// into lanes and back. Code that uses Floats must be in the same region (simd/region.hpp).
#pragma once

#include <bit>
#include <cstdint>

#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

#if ECODS_CAN_DISPATCH
#include <immintrin.h>

ECODS_BEGIN_WIDE
namespace ecods::wide {

#include "simd/vec_text.hpp"

using Floats = __m512;
using Mask = __mmask16;
using Float8 = __m256;
using Index8 = __m256i;  // eight 32-bit integers

// all_lanes is the mask of all lanes. It is passed to masked intrinsics where g++ 12 warns that the unmasked intrinsic
// uses an uninitialised value.
inline constexpr Mask all_lanes = 0xffff;

// Returns eight floats twice: in lanes 0 to 7 and again in lanes 8 to 15. `eight` must be aligned as a vector of eight.
ECODS_ALWAYS_INLINE Floats twice(const float* eight) noexcept {
    return _mm512_maskz_broadcast_f32x8(all_lanes, _mm256_load_ps(eight));
}

// Returns lane `first` of v in lanes 0 to 7, and lane first + 1 of v in lanes 8 to 15.
template <int first>
ECODS_ALWAYS_INLINE Floats two_of(Floats v) noexcept {
    constexpr int a = first, b = first + 1;
    return _mm512_maskz_permutexvar_ps(all_lanes, _mm512_setr_epi32(a, a, a, a, a, a, a, a, b, b, b, b, b, b, b, b), v);
}

// not_above() returns the lanes in `lanes` in which x > y is false, and not_below() the lanes in which x < y is false.
// Both comparisons are false if a number is NaN.
ECODS_ALWAYS_INLINE Mask not_above(Mask lanes, Floats x, Floats y) noexcept {
    return _mm512_mask_cmp_ps_mask(lanes, x, y, _CMP_NGT_UQ);
}
ECODS_ALWAYS_INLINE Mask not_below(Mask lanes, Floats x, Floats y) noexcept {
    return _mm512_mask_cmp_ps_mask(lanes, x, y, _CMP_NLT_UQ);
}

// Returns a mask of the lanes in which the interval [low, high] may meet [from, to]: neither low > to nor high < from
// holds.
ECODS_ALWAYS_INLINE std::uint32_t not_outside(Float8 low, Float8 high, float from, float to) noexcept {
    const __mmask8 not_beyond = _mm256_cmp_ps_mask(low, _mm256_set1_ps(to), _CMP_NGT_UQ);
    return _mm256_mask_cmp_ps_mask(not_beyond, high, _mm256_set1_ps(from), _CMP_NLT_UQ);
}

// Expands a mask of eight bits to eight bytes: byte i is 0xff if bit i is set, otherwise 0.
ECODS_ALWAYS_INLINE std::uint64_t bytes_of(std::uint32_t mask) noexcept {
    return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_movm_epi8(static_cast<__mmask16>(mask))));
}

// Returns a word in which each of the eight bytes is `number`, which must be below 256.
ECODS_ALWAYS_INLINE std::uint64_t in_each_byte(std::uint64_t number) noexcept {
    return number * 0x0101010101010101u;
}

// Holds the eight lowest bits that are set in a 64-bit word, as numbers 8 j + i, one in each lane. If fewer bits are
// set, the remaining lanes repeat the lowest one.
struct PairNumbers {
    Index8 i, j;
    std::uint64_t bits;  // the word with only these bits set

    // Moves the eight lowest set bits, or all if there are fewer, from `from` to `bits`. `from` must not be zero.
    ECODS_ALWAYS_INLINE explicit PairNumbers(std::uint64_t& from) noexcept {
        bits = from;
        const auto first = static_cast<std::uint64_t>(std::countr_zero(from));
        std::uint64_t numbers = in_each_byte(first);
        from &= from - 1;
        for (int lane = 8; from != 0 && lane < 64; lane += 8, from &= from - 1) {
            numbers ^= (static_cast<std::uint64_t>(std::countr_zero(from)) ^ first) << lane;
        }
        bits ^= from;
        const __m256i lanes = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(numbers)));
        i = _mm256_and_si256(lanes, _mm256_set1_epi32(7));
        j = _mm256_srli_epi32(lanes, 3);
    }

    // Returns the bits of the pairs whose lane in `lanes` is all ones. Each lane must be all ones or zero.
    ECODS_ALWAYS_INLINE std::uint64_t bits_of(const Vec<std::int32_t, 8>& lanes) const noexcept {
        const __mmask8 mask = _mm256_movepi32_mask(_mm256_load_si256(reinterpret_cast<const __m256i*>(&lanes)));
        return _pdep_u64(mask, bits);
    }
};

// Returns eight[index[k]] in lane k. `eight` must be aligned as a vector of eight floats.
ECODS_ALWAYS_INLINE Float8 pick(const float* eight, Index8 index) noexcept {
    return _mm256_permutexvar_ps(index, _mm256_load_ps(eight));
}
ECODS_ALWAYS_INLINE void store(Float8 v, Vec<float, 8>& lanes) noexcept {
    _mm256_store_ps(reinterpret_cast<float*>(&lanes), v);
}

// larger() returns a > b ? a : b in each lane, and smaller() returns a < b ? a : b.
ECODS_ALWAYS_INLINE Float8 larger(Float8 a, Float8 b) noexcept {
    return _mm256_max_ps(a, b);
}
ECODS_ALWAYS_INLINE Float8 smaller(Float8 a, Float8 b) noexcept {
    return _mm256_min_ps(a, b);
}

}  // namespace ecods::wide
ECODS_END_REGION

#endif
