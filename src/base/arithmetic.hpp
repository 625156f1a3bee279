// Requirements on the compiler and on floating-point arithmetic are checked here, at compile time.
#pragma once

#include <cfloat>
#include <climits>
#include <limits>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || __FINITE_MATH_ONLY__
#error "ECoDS cannot be compiled with -ffast-math or parts of it: the filter's proof is about operations as written."
#endif
#if !defined(__GNUC__) || !defined(__SIZEOF_INT128__)
#error "ECoDS needs the GNU extensions of g++ and clang (__int128, vectors), on a 64-bit processor."
#endif

namespace ecods {

// All proofs in this library assume that double is IEEE binary64 and is evaluated as binary64: no x87 registers, no
// wider intermediates. The proofs hold with contraction to fused multiply-add, in any rounding mode, and with
// flush-to-zero.
static_assert(std::numeric_limits<double>::is_iec559 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024);
static_assert(FLT_EVAL_METHOD == 0);
static_assert(CHAR_BIT == 8);

// two_u is twice the unit roundoff u = 2^-53: an upper bound of the relative error of one operation in any rounding
// mode.
inline constexpr double two_u = 0x1p-52;

}  // namespace ecods
