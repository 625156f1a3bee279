// One function, compiled for several instruction sets; which of them runs is asked at each call.
//
// Versions differ in width only: nothing is contracted (-ffp-contract=off), so every version gives the same bits.
#pragma once

#include <type_traits>
#include <utility>

#include "simd/inline.hpp"
#include "simd/instruction_set.hpp"

// A build with ECODS_BASELINE_ONLY has the plain versions and no others: what it answers is compared with the rest.
#if defined(__x86_64__) && !defined(ECODS_BASELINE_ONLY)
#define ECODS_CAN_DISPATCH 1
#else
#define ECODS_CAN_DISPATCH 0
#endif

namespace ecods {

// body(arguments...), or where it is a member, (first of arguments.*body)(the others...).
template <auto body, class First, class... Rest>
ECODS_ALWAYS_INLINE decltype(auto) call(First&& first, Rest&&... rest) {
    if constexpr (std::is_member_function_pointer_v<decltype(body)>) {
        return (first.*body)(std::forward<Rest>(rest)...);
    } else {
        return body(std::forward<First>(first), std::forward<Rest>(rest)...);
    }
}

// The versions. What is always inlined is compiled for the function that it ends up in; these three never are, so that
// a caller holds nothing but the choice.
template <auto body, class... Arguments>
[[gnu::noinline]] decltype(auto) on_baseline(Arguments&&... arguments) {
    return call<body>(std::forward<Arguments>(arguments)...);
}
#if ECODS_CAN_DISPATCH
template <auto body, class... Arguments>
[[gnu::noinline, gnu::target("avx2")]] decltype(auto) on_avx2(Arguments&&... arguments) {
    return call<body>(std::forward<Arguments>(arguments)...);
}
template <auto body, class... Arguments>
[[gnu::noinline, gnu::target("avx512f")]] decltype(auto) on_avx512(Arguments&&... arguments) {
    return call<body>(std::forward<Arguments>(arguments)...);
}
#endif

// Calls `body`, which must be ECODS_ALWAYS_INLINE and so must all be that it leaves its loops to, compiled for the
// instruction set in use. Cost: a load and a branch or two.
template <auto body, class... Arguments>
ECODS_ALWAYS_INLINE decltype(auto) dispatch(Arguments&&... arguments) {
#if ECODS_CAN_DISPATCH
    const InstructionSet set = read_instruction_set();
    if (set == InstructionSet::avx2) return on_avx2<body>(std::forward<Arguments>(arguments)...);
    if (set == InstructionSet::avx512) return on_avx512<body>(std::forward<Arguments>(arguments)...);
#endif
    return on_baseline<body>(std::forward<Arguments>(arguments)...);
}

// As dispatch, for bodies that are written for a width of registers: `four_wide` for registers of four floats, which
// every x86-64 has, `eight_wide` for those of eight. The set is read here and not asked for: with a call in it, the
// caller of a short body keeps its arguments in memory across that call (18 instructions each time in place of 6, 2 %
// of a query of meshes).
template <auto four_wide, auto eight_wide, class... Arguments>
ECODS_ALWAYS_INLINE decltype(auto) dispatch_by_width(Arguments&&... arguments) {
#if ECODS_CAN_DISPATCH
    if (read_instruction_set() != InstructionSet::baseline) {
        return on_avx2<eight_wide>(std::forward<Arguments>(arguments)...);
    }
#endif
    return on_baseline<four_wide>(std::forward<Arguments>(arguments)...);
}

// As dispatch_by_width, with a third body for registers of sixteen floats: a function for InstructionSet::avx512 itself
// (ECODS_WIDE in simd/wide.hpp), which is called as it is.
#if ECODS_CAN_DISPATCH
template <auto four_wide, auto eight_wide, auto sixteen_wide, class... Arguments>
ECODS_ALWAYS_INLINE decltype(auto) dispatch_by_three_widths(Arguments&&... arguments) {
    const InstructionSet in_use = read_instruction_set();
    if (in_use == InstructionSet::avx512) return sixteen_wide(std::forward<Arguments>(arguments)...);
    if (in_use == InstructionSet::avx2) return on_avx2<eight_wide>(std::forward<Arguments>(arguments)...);
    return on_baseline<four_wide>(std::forward<Arguments>(arguments)...);
}
#endif

}  // namespace ecods
