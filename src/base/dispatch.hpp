// One function, compiled for several instruction sets; the dynamic linker picks the processor's when the program
// starts.
#pragma once

// The sanitizers' runtimes are not ready yet when the linker asks; their builds have the plain version only.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ECODS_IS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define ECODS_IS_SANITIZED 1
#endif
#endif

// A build with ECODS_BASELINE_ONLY has the plain versions and no others: what it answers is compared with the rest.
//
// Versions differ in width only: nothing is contracted (-ffp-contract=off), so every version gives the same bits.
#if defined(__x86_64__) && !defined(ECODS_BASELINE_ONLY)
#define ECODS_CAN_DISPATCH 1  // by hand: functions with a target, and __builtin_cpu_supports
#endif
#if defined(ECODS_CAN_DISPATCH) && defined(__gnu_linux__) && !defined(ECODS_IS_SANITIZED)
#define ECODS_FOR_EACH_INSTRUCTION_SET __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define ECODS_FOR_EACH_INSTRUCTION_SET
#endif
