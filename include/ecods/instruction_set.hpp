// Which of the processor's instructions the library uses.
//
// Its hot functions are compiled several times, for narrow and for wide registers, and the widest version that the
// processor and the operating system support is used. Nobody has to choose: no answer, list, event, digest, count or
// box depends on it, since versions differ in the width of their registers only. Limit it to measure, to compare, or
// where wide instructions slow down other work of the processor.
//
// It is one setting for all of a process: all threads, all worlds, all queries. There is no environment variable for
// it.
//
// Thread safety: all of these may be called from any thread, at any time once main() has begun.
//
// Example: verify/examples/how_do_i, limit_instructions().
#pragma once

#include <cstdint>
#include <iosfwd>

#include "ecods/export.hpp"

namespace ecods {

// From narrow to wide. Baseline is what the compiler was set to compile for: what every x86-64 has, unless the flags
// of the build say otherwise. On other processors there is nothing else. avx512 is its parts F, BW, DQ and VL, and
// BMI2: of a processor that lacks one of them, avx2 is used.
enum class InstructionSet : std::uint8_t { baseline, avx2, avx512 };

// The widest that this processor and the operating system support, and that the library has a version for.
ECODS_API InstructionSet supported_instruction_set() noexcept;

// The one in use: the supported one, unless it was limited.
ECODS_API InstructionSet instruction_set() noexcept;

// From now on, nothing wider than `widest` is used. Where the processor does not support `widest` either, the widest
// that it does support is used: limit_instruction_set(avx512) removes the limit. Calls that are under way in other
// threads may end as they began.
ECODS_API void limit_instruction_set(InstructionSet widest) noexcept;

ECODS_API std::ostream& operator<<(std::ostream& out, InstructionSet set);  // "baseline", "avx2", "avx512"

}  // namespace ecods
