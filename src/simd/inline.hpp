// ECODS_ALWAYS_INLINE marks functions of the hot path that must be inlined, whatever the compiler's heuristics say. In
// a region (simd/region.hpp) inlining affects only speed: there `-D ECODS_ALWAYS_INLINE=inline` may leave the choice to
// the compiler.
#pragma once

#ifndef ECODS_ALWAYS_INLINE
#define ECODS_ALWAYS_INLINE [[gnu::always_inline]] inline
#endif

// ECODS_INLINE_LAMBDA must follow the parameters of each lambda that takes or returns vectors by value and is called
// from functions of several instruction sets. If the lambda were not inlined, caller and lambda could disagree on
// passing vectors in memory or in registers: without optimization the program crashed.
#define ECODS_INLINE_LAMBDA __attribute__((always_inline))
