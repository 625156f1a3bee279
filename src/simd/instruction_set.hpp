// Which versions of the functions that are compiled more than once (base/dispatch.hpp) are used.
//
// Answers, counts of work and boxes do not depend on it: versions differ in the width of their registers only.
#pragma once

#include <atomic>
#include <cstdint>

namespace ecods {

// From narrow to wide. Baseline is what the compiler was told to compile for: what every x86-64 has, unless the user
// says otherwise.
enum class InstructionSet : std::uint8_t { baseline, avx2, avx512 };

// The widest that the processor and the operating system support, and that the library has versions for.
InstructionSet supported_instruction_set() noexcept;

// The library's own; read through the functions below.
extern std::atomic<InstructionSet> instruction_set_in_use;

// The one in use: the widest that is supported, unless it was limited. (Baseline until the library's objects of
// namespace scope have been initialised.) Safe from many threads, as the next one is.
inline InstructionSet instruction_set() noexcept {
    return instruction_set_in_use.load(std::memory_order_relaxed);
}

// From now on uses nothing wider than `widest`, in all threads and worlds: for checks and measurements. What the
// processor does not support is not used even if it is asked for. Calls that have begun may end as they began.
void limit_instruction_set(InstructionSet widest) noexcept;

}  // namespace ecods
