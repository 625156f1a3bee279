// Registers of eight doubles, on processors that have them: two of four side by side, or eight of one kind. As in
// simd/wide.hpp, whoever uses these must be a function for InstructionSet::avx512.
#pragma once

#include "bounds/double4.hpp"
#include "simd/wide.hpp"

#if ECODS_CAN_DISPATCH

namespace ecods {

using Double8 = __m512d;

ECODS_WIDE_INLINE Double8 join(Double4 low, Double4 high) noexcept {
    return _mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(bits_as<__m256d>(low)), bits_as<__m256d>(high), 1);
}
ECODS_WIDE_INLINE Double4 low_half(Double8 v) noexcept {
    return bits_as<Double4>(_mm512_maskz_extractf64x4_pd(0xff, v, 0));
}
ECODS_WIDE_INLINE Double4 high_half(Double8 v) noexcept {
    return bits_as<Double4>(_mm512_maskz_extractf64x4_pd(0xff, v, 1));
}

ECODS_WIDE_INLINE Double8 eight(double x) noexcept {
    return _mm512_set1_pd(x);
}
ECODS_WIDE_INLINE Double8 absolute(Double8 v) noexcept {
    return _mm512_abs_pd(v);
}
// Not where a lane is a NaN.
ECODS_WIDE_INLINE __mmask8 is_less(Double8 a, Double8 b) noexcept {
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}

}  // namespace ecods

#endif
