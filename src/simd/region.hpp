// A region is a part of a source file that belongs to one instruction set: all definitions in it are compiled for that
// set, including member functions, templates and lambdas, inlined or not. Each region has its own namespace (baseline,
// avx2, or wide for AVX-512), so two sets never share a function.
//
// g++ 12 ignores the region for two kinds of functions, which must not be used in one: friends that a class template
// defines, and constructors that the compiler declares by itself (inherited ones, and those that set members to their
// default initialisers).
//
// Regions share source: simd/each_set.hpp includes one file in each region. Code for AVX-512 alone is written between
// ECODS_BEGIN_WIDE and ECODS_END_REGION.
#pragma once

// ECODS_BASELINE_ONLY leaves out all versions but the baseline's. Answers of such a build are compared with answers of
// other builds.
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

// Code outside of all regions uses the baseline's functions. These functions are made visible by a using directive and
// not an inline namespace: otherwise argument-dependent lookup would find functions of the baseline in the region of
// another set.
namespace baseline {}
using namespace baseline;

}  // namespace ecods
