// ECODS_ALWAYS_INLINE marks functions of the hot path that must not become calls, whatever a compiler's heuristics say.
// In a region (simd/region.hpp) it is a matter of speed alone: `-D ECODS_ALWAYS_INLINE=inline` leaves it to the
// compiler.
#pragma once

#ifndef ECODS_ALWAYS_INLINE
#define ECODS_ALWAYS_INLINE [[gnu::always_inline]] inline
#endif

// Stands after the parameters of a lambda that takes or returns vectors by value and is called in functions of several
// instruction sets. As a call it would pass vectors in memory where wider sets pass them in registers: without
// optimization the program crashed.
#define ECODS_INLINE_LAMBDA __attribute__((always_inline))
