// A dispatched function is compiled once for each instruction set; a call runs the version for the set in use.
//
// All versions give the same bits: they differ only in the width of registers, and none is contracted to fused
// multiply-add (-ffp-contract=off).
#pragma once

#include <type_traits>
#include <utility>

#include "simd/inline.hpp"
#include "simd/instruction_set.hpp"
#include "simd/region.hpp"

namespace ecods {

// Calls body(arguments...) or, if body is a member function, (first.*body)(rest...).
template <auto body, class First, class... Rest>
ECODS_ALWAYS_INLINE decltype(auto) call(First&& first, Rest&&... rest) {
    if constexpr (std::is_member_function_pointer_v<decltype(body)>) {
        return (first.*body)(std::forward<Rest>(rest)...);
    } else {
        return body(std::forward<First>(first), std::forward<Rest>(rest)...);
    }
}

// Each on_...() function inlines `body` and compiles it for one instruction set. The on_...() functions are not inlined
// themselves, so their callers contain only the choice among them.
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

// Calls `body`, compiled for the instruction set in use. `body`, and every function with a loop that it calls, must be
// ECODS_ALWAYS_INLINE. Cost: a load and one or two branches.
template <auto body, class... Arguments>
ECODS_ALWAYS_INLINE decltype(auto) dispatch(Arguments&&... arguments) {
#if ECODS_CAN_DISPATCH
    const InstructionSet set = read_instruction_set();
    if (set == InstructionSet::avx2) return on_avx2<body>(std::forward<Arguments>(arguments)...);
    if (set == InstructionSet::avx512) return on_avx512<body>(std::forward<Arguments>(arguments)...);
#endif
    return on_baseline<body>(std::forward<Arguments>(arguments)...);
}

// Calls one of two functions that are written for a width of registers: `four_wide` for registers of four floats, which
// every x86-64 has, `eight_wide` for registers of eight. The instruction set is read inline: if it were read by a
// function call, the caller of a short body would keep its arguments in memory across that call (18 instructions in
// place of 6 each time, 2 % of a query of meshes).
template <auto four_wide, auto eight_wide, class... Arguments>
ECODS_ALWAYS_INLINE decltype(auto) dispatch_by_width(Arguments&&... arguments) {
#if ECODS_CAN_DISPATCH
    if (read_instruction_set() != InstructionSet::baseline) {
        return on_avx2<eight_wide>(std::forward<Arguments>(arguments)...);
    }
#endif
    return on_baseline<four_wide>(std::forward<Arguments>(arguments)...);
}

// Lists the versions of a function that simd/each_set.hpp has compiled, one for each set, as template arguments of
// call_widest().
#if ECODS_CAN_DISPATCH
#define ECODS_OF_EACH_SET(...) baseline::__VA_ARGS__, avx2::__VA_ARGS__
#else
#define ECODS_OF_EACH_SET(...) baseline::__VA_ARGS__, baseline::__VA_ARGS__
#endif

// Named<f> is a type that stands for the function f. With g++'s undefined-behaviour sanitizer, the comparison of two
// functions' addresses is no constant expression, but the comparison of two types Named<f> is one.
template <auto function>
struct Named {};

// Calls the version of a function for the instruction set in use. Most functions have no version for AVX-512: then the
// version for AVX2 is called.
template <auto of_baseline, auto of_avx2, auto of_avx512 = of_avx2, class... Arguments>
ECODS_ALWAYS_INLINE decltype(auto) call_widest(Arguments&&... arguments) {
#if ECODS_CAN_DISPATCH
    const InstructionSet in_use = read_instruction_set();
    if constexpr (!std::is_same_v<Named<of_avx512>, Named<of_avx2>>) {
        if (in_use == InstructionSet::avx512) return of_avx512(std::forward<Arguments>(arguments)...);
    }
    if (in_use != InstructionSet::baseline) return of_avx2(std::forward<Arguments>(arguments)...);
#endif
    return of_baseline(std::forward<Arguments>(arguments)...);
}

}  // namespace ecods
