// Floats is a register of sixteen floats, on processors that have it, with masks of as many bits: two rows of eight
// lanes at once.
//
// These are intrinsics and not Vec, because comparisons give masks here: g++ turns masks of Vec into lanes and back.
// Code that uses them must be in the same region (simd/region.hpp).
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
using Index8 = __m256i;  // eight integers of 32 bits

// Selects every lane. Intrinsics take it where g++ 12 warns that their plain form uses an uninitialised value.
inline constexpr Mask all_lanes = 0xffff;

// Returns eight floats, aligned as a vector of eight, in the first eight lanes and again in the last.
ECODS_ALWAYS_INLINE Floats twice(const float* eight) noexcept {
    return _mm512_maskz_broadcast_f32x8(all_lanes, _mm256_load_ps(eight));
}

// Returns float `first` of twice()'s eight in the first eight lanes, and the next float in the last eight.
template <int first>
ECODS_ALWAYS_INLINE Floats two_of(Floats v) noexcept {
    constexpr int a = first, b = first + 1;
    return _mm512_maskz_permutexvar_ps(all_lanes, _mm512_setr_epi32(a, a, a, a, a, a, a, a, b, b, b, b, b, b, b, b), v);
}

// Return the lanes of a mask in which x > y, or x < y, does not hold; neither holds for a NaN.
ECODS_ALWAYS_INLINE Mask not_above(Mask lanes, Floats x, Floats y) noexcept {
    return _mm512_mask_cmp_ps_mask(lanes, x, y, _CMP_NGT_UQ);
}
ECODS_ALWAYS_INLINE Mask not_below(Mask lanes, Floats x, Floats y) noexcept {
    return _mm512_mask_cmp_ps_mask(lanes, x, y, _CMP_NLT_UQ);
}

// Returns the lanes, as bits, in which neither low > to nor high < from holds.
ECODS_ALWAYS_INLINE std::uint32_t not_outside(Float8 low, Float8 high, float from, float to) noexcept {
    const __mmask8 not_beyond = _mm256_cmp_ps_mask(low, _mm256_set1_ps(to), _CMP_NGT_UQ);
    return _mm256_mask_cmp_ps_mask(not_beyond, high, _mm256_set1_ps(from), _CMP_NLT_UQ);
}

// Returns eight bits for each bit of a mask of eight.
ECODS_ALWAYS_INLINE std::uint64_t bytes_of(std::uint32_t mask) noexcept {
    return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_movm_epi8(static_cast<__mmask16>(mask))));
}

// Returns a number below 256 in each of eight bytes.
ECODS_ALWAYS_INLINE std::uint64_t in_each_byte(std::uint64_t number) noexcept {
    return number * 0x0101010101010101u;
}

// Holds the numbers 8 j + i of the lowest eight bits that are set in a word, one in each lane; if fewer are set, the
// last lanes repeat the first.
struct PairNumbers {
    Index8 i, j;
    std::uint64_t bits;  // the bits of these pairs

    // Takes the bits out of `from`, which must not be zero.
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

    // Returns the bits of the pairs whose lanes are all ones, not zero.
    ECODS_ALWAYS_INLINE std::uint64_t bits_of(const Vec<std::int32_t, 8>& lanes) const noexcept {
        const __mmask8 mask = _mm256_movepi32_mask(_mm256_load_si256(reinterpret_cast<const __m256i*>(&lanes)));
        return _pdep_u64(mask, bits);
    }
};

// Returns float index[k] of eight in lane k; the eight are aligned as a vector.
ECODS_ALWAYS_INLINE Float8 pick(const float* eight, Index8 index) noexcept {
    return _mm256_permutexvar_ps(index, _mm256_load_ps(eight));
}
ECODS_ALWAYS_INLINE void store(Float8 v, Vec<float, 8>& lanes) noexcept {
    _mm256_store_ps(reinterpret_cast<float*>(&lanes), v);
}

// Return a > b ? a : b, and a < b ? a : b, lane by lane.
ECODS_ALWAYS_INLINE Float8 larger(Float8 a, Float8 b) noexcept {
    return _mm256_max_ps(a, b);
}
ECODS_ALWAYS_INLINE Float8 smaller(Float8 a, Float8 b) noexcept {
    return _mm256_min_ps(a, b);
}

}  // namespace ecods::wide
ECODS_END_REGION

#endif
