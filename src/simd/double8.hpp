// Double8 is a register of eight doubles, on processors with AVX-512. It holds two vectors of four side by side (its
// "halves"), or eight numbers of one kind. Code that uses Double8 must be between ECODS_BEGIN_WIDE and ECODS_END_REGION
// (simd/region.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "simd/wide.hpp"

#if ECODS_CAN_DISPATCH

ECODS_BEGIN_WIDE
namespace ecods::wide {

using Double8 = Vec<double, 8>;
using Mask8 = __mmask8;  // bit i is lane i
using Int8 = Vec<std::int32_t, 8>;

// The functions up to load_three() work on the two halves of a register.

ECODS_ALWAYS_INLINE Double8 join(Vec<double, 4> low, Vec<double, 4> high) noexcept {
    return _mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(bits_as<__m256d>(low)), bits_as<__m256d>(high), 1);
}
ECODS_ALWAYS_INLINE Vec<double, 4> low_half(Double8 v) noexcept {
    return bits_as<Vec<double, 4>>(_mm512_maskz_extractf64x4_pd(0xff, v, 0));
}
ECODS_ALWAYS_INLINE Vec<double, 4> high_half(Double8 v) noexcept {
    return bits_as<Vec<double, 4>>(_mm512_maskz_extractf64x4_pd(0xff, v, 1));
}

// Returns a vector whose low half is half `low` of v, and whose high half is half `high` of v (0 or 1 each).
template <int low, int high>
ECODS_ALWAYS_INLINE Double8 halves(Double8 v) noexcept {
    return _mm512_maskz_shuffle_f64x2(0xff, v, v, _MM_SHUFFLE(2 * high + 1, 2 * high, 2 * low + 1, 2 * low));
}

// Copies lane `lane` of each half into all four lanes of that half.
template <int lane>
ECODS_ALWAYS_INLINE Double8 each(Double8 v) noexcept {
    return _mm512_maskz_permutex_pd(0xff, v, lane * 0x55);
}

// both() sets all lanes of the low half to `low` and of the high half to `high`. swapped() exchanges the halves. sum()
// adds lanes 0, 1 and 2 of each half; all lanes of the half get the sum.
ECODS_ALWAYS_INLINE Double8 both(double low, double high) noexcept {
    return join(broadcast<Vec<double, 4>>(low), broadcast<Vec<double, 4>>(high));
}
ECODS_ALWAYS_INLINE Double8 swapped(Double8 v) noexcept {
    return halves<1, 0>(v);
}
ECODS_ALWAYS_INLINE Double8 sum(Double8 v) noexcept {
    return (each<0>(v) + each<1>(v)) + each<2>(v);
}

// Load three numbers into the first three lanes of each half. The fourth lane of each half is zero.
ECODS_ALWAYS_INLINE Double8 load_three(const double* low, const double* high) noexcept {
    return _mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(_mm256_maskz_loadu_pd(7, low)),
                                    _mm256_maskz_loadu_pd(7, high), 1);
}
ECODS_ALWAYS_INLINE Double8 load_three(const float* low, const float* high) noexcept {
    return _mm512_maskz_cvtps_pd(0xff, _mm256_set_m128(_mm_maskz_loadu_ps(7, high), _mm_maskz_loadu_ps(7, low)));
}

// The functions up to next_up_of_finite() work on the eight lanes of a register.

ECODS_ALWAYS_INLINE Double8 eight(double x) noexcept {
    return _mm512_set1_pd(x);
}
ECODS_ALWAYS_INLINE Double8 absolute(Double8 v) noexcept {
    return _mm512_abs_pd(v);
}
// Changes the sign of each lane of v for which the same lane of `signs` is -0; that lane must be 0 or -0.
ECODS_ALWAYS_INLINE Double8 flip(Double8 v, Double8 signs) noexcept {
    return _mm512_xor_pd(v, signs);
}
ECODS_ALWAYS_INLINE Double8 negative(Double8 v) noexcept {
    return flip(v, eight(-0.0));
}

// A comparison is false in each lane in which an argument is NaN.
ECODS_ALWAYS_INLINE Mask8 is_less(Double8 a, Double8 b) noexcept {
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
ECODS_ALWAYS_INLINE Mask8 is_at_most(Double8 a, Double8 b) noexcept {
    return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ);
}
ECODS_ALWAYS_INLINE Mask8 is_greater(Double8 a, Double8 b) noexcept {
    return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ);
}
ECODS_ALWAYS_INLINE bool are_below(Double8 numbers, double limit) noexcept {
    return is_less(numbers, eight(limit)) == 0xff;
}
ECODS_ALWAYS_INLINE bool are_at_most(Double8 numbers, double limit) noexcept {
    return is_at_most(numbers, eight(limit)) == 0xff;
}
ECODS_ALWAYS_INLINE bool all(std::uint32_t mask) noexcept {
    return mask == 0xff;
}
ECODS_ALWAYS_INLINE Double8 either(Mask8 mask, Double8 yes, Double8 no) noexcept {
    return _mm512_mask_blend_pd(mask, no, yes);
}
// larger() returns a > b ? a : b in each lane, and smaller() returns a < b ? a : b.
ECODS_ALWAYS_INLINE Double8 larger(Double8 a, Double8 b) noexcept {
    return _mm512_maskz_max_pd(0xff, a, b);
}
ECODS_ALWAYS_INLINE Double8 smaller(Double8 a, Double8 b) noexcept {
    return _mm512_maskz_min_pd(0xff, a, b);
}

// even_lanes() returns a[0], b[0], a[2], b[2], a[4], b[4], a[6], b[6]; odd_lanes() does the same for lanes 1, 3, 5 and
// 7.
ECODS_ALWAYS_INLINE Double8 even_lanes(Double8 a, Double8 b) noexcept {
    return _mm512_maskz_unpacklo_pd(0xff, a, b);
}
ECODS_ALWAYS_INLINE Double8 odd_lanes(Double8 a, Double8 b) noexcept {
    return _mm512_maskz_unpackhi_pd(0xff, a, b);
}
// Returns eight lanes chosen by number: numbers 0 to 7 are the lanes of a, and 8 to 15 the lanes of b.
template <int i, int j, int k, int l, int m, int n, int o, int p>
ECODS_ALWAYS_INLINE Double8 lanes_of(Double8 a, Double8 b) noexcept {
    return _mm512_permutex2var_pd(a, _mm512_setr_epi64(i, j, k, l, m, n, o, p), b);
}

// Returns next_up(x) in each lane. x must be neither infinite nor NaN.
ECODS_ALWAYS_INLINE Double8 next_up_of_finite(Double8 x) noexcept {
    const __m512i bits = _mm512_castpd_si512(x), one = _mm512_set1_epi64(1);
    const __m512i up = _mm512_add_epi64(bits, one);
    const __m512i next = _mm512_mask_sub_epi64(up, _mm512_movepi64_mask(bits), bits, one);
    const Mask8 is_zero = _mm512_cmpeq_epi64_mask(_mm512_add_epi64(bits, bits), _mm512_setzero_si512());
    return _mm512_castsi512_pd(_mm512_mask_mov_epi64(next, is_zero, one));
}

// The functions below convert lanes to integers, and work on eight integers.

// truncated() rounds each lane towards zero to an integer from -2^31 to 2^31 - 1; doubles_of() converts back.
ECODS_ALWAYS_INLINE Int8 truncated(Double8 v) noexcept {
    return bits_as<Int8>(_mm512_maskz_cvttpd_epi32(0xff, v));
}
ECODS_ALWAYS_INLINE Double8 doubles_of(Int8 v) noexcept {
    return _mm512_maskz_cvtepi32_pd(0xff, bits_as<__m256i>(v));
}
ECODS_ALWAYS_INLINE Int8 either(Mask8 mask, Int8 yes, Int8 no) noexcept {
    return bits_as<Int8>(_mm256_mask_mov_epi32(bits_as<__m256i>(no), mask, bits_as<__m256i>(yes)));
}

// load_pairs() sets first[i] to table[2 places[i]] and second[i] to table[2 places[i] + 1], for i from 0 to 7. It loads
// each pair by itself, which measured a little faster than a gather of eight numbers.
struct EightPlaces {
    alignas(32) std::array<std::int32_t, 8> at;
};
ECODS_ALWAYS_INLINE EightPlaces places_of(Int8 numbers) noexcept {
    EightPlaces places;
    store(places.at.data(), numbers);
    return places;
}
ECODS_ALWAYS_INLINE void load_pairs(const float* table, const EightPlaces& places, Double8& first,
                                    Double8& second) noexcept {
    const auto two = [&](std::size_t i) {
        const auto pair = [&](std::size_t k) {
            return reinterpret_cast<const __m64*>(table + 2 * static_cast<std::ptrdiff_t>(places.at[k]));
        };
        return _mm_loadh_pi(_mm_loadl_pi(_mm_setzero_ps(), pair(i)), pair(i + 1));
    };
    const __m256 low = _mm256_set_m128(two(4), two(0)), high = _mm256_set_m128(two(6), two(2));
    first = _mm512_maskz_cvtps_pd(0xff, _mm256_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0)));
    second = _mm512_maskz_cvtps_pd(0xff, _mm256_shuffle_ps(low, high, _MM_SHUFFLE(3, 1, 3, 1)));
}

}  // namespace ecods::wide
ECODS_END_REGION

#endif
