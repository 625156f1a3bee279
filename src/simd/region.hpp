// A region belongs to an instruction set: all definitions between its beginning and its end are compiled for that set,
// member functions, templates and lambdas included, inlined or not. Each region has a namespace of its own (baseline,
// avx2, and wide for AVX-512), so that two sets never share a function.
//
// With g++ 12 two kinds of functions stay outside of a region, and so must not be used in one: friends that a class
// template defines, and constructors that the compiler declares by itself (inherited ones, and those that set members
// to their default initialisers).
//
// Regions share one text, which simd/each_set.hpp includes in each. Code for AVX-512 alone stands between
// ECODS_BEGIN_WIDE and ECODS_END_REGION.
#pragma once

// A build with ECODS_BASELINE_ONLY has only the baseline versions: its answers are compared with those of other builds.
#if defined(__x86_64__) && !defined(ECODS_BASELINE_ONLY)
#define ECODS_CAN_DISPATCH 1
#else
#define ECODS_CAN_DISPATCH 0
#endif

#define ECODS_PRAGMA(text) _Pragma(#text)
#if defined(__clang__)
#define ECODS_BEGIN_REGION(set) ECODS_PRAGMA(clang attribute push(__attribute__((target(set))), apply_to = function))
#define ECODS_END_REGION ECODS_PRAGMA(clang attribute pop)
#else
#define ECODS_BEGIN_REGION(set) ECODS_PRAGMA(GCC push_options) ECODS_PRAGMA(GCC target(set))
#define ECODS_END_REGION ECODS_PRAGMA(GCC pop_options)
#endif

#define ECODS_BEGIN_AVX2 ECODS_BEGIN_REGION("avx2")
#define ECODS_BEGIN_WIDE ECODS_BEGIN_REGION("avx512f,avx512bw,avx512dq,avx512vl,bmi,bmi2")

namespace ecods {

// Code outside of all regions is compiled for the baseline. (A using directive, not an inline namespace:
// argument-dependent lookup must not bring functions of the baseline into a region of another set.)
namespace baseline {}
using namespace baseline;

}  // namespace ecods
