#include "simd/instruction_set.hpp"

#include <algorithm>
#include <ostream>

#include "simd/dispatch.hpp"

namespace ecods {

constinit std::atomic<InstructionSet> instruction_set_in_use = InstructionSet::baseline;

InstructionSet supported_instruction_set() noexcept {
#if ECODS_CAN_DISPATCH
    __builtin_cpu_init();
    // simd/wide.hpp needs all of these features. The first processors with AVX-512 had avx512f, but not the next three.
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("bmi2")) {
        return InstructionSet::avx512;
    }
    if (__builtin_cpu_supports("avx2")) return InstructionSet::avx2;
#endif
    return InstructionSet::baseline;
}

InstructionSet instruction_set() noexcept {
    return read_instruction_set();
}

void limit_instruction_set(InstructionSet widest) noexcept {
    instruction_set_in_use.store(std::min(widest, supported_instruction_set()), std::memory_order_relaxed);
}

std::ostream& operator<<(std::ostream& out, InstructionSet set) {
    return out << (set == InstructionSet::baseline ? "baseline" : set == InstructionSet::avx2 ? "avx2" : "avx512");
}

namespace {

[[maybe_unused]] const bool is_unlimited = (limit_instruction_set(InstructionSet::avx512), true);

}  // namespace
}  // namespace ecods
