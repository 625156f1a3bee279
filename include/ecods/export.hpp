// Checks for C++20, and defines the library's version and the macros that mark which names a shared library exports.
#pragma once

#if __cplusplus < 202002L
#error "ECoDS needs C++20: compile with -std=c++20 or a later standard."
// Includes a file that does not exist: the compiler stops here, before it reports all that an older standard lacks.
#define ECODS_STOP "the error above"
#include ECODS_STOP
#endif

// CMake reads the version from these three lines.
#define ECODS_VERSION_MAJOR 0
#define ECODS_VERSION_MINOR 4
#define ECODS_VERSION_PATCH 0

// Marks a name that belongs to the library's interface. A shared library hides all other names; in a static library the
// mark has no effect.
#define ECODS_API [[gnu::visibility("default")]]

// Marks a member of a public class that is not part of the interface.
#define ECODS_HIDDEN [[gnu::visibility("hidden")]]

#include <cstdint>
#include <iosfwd>

namespace ecods {

// ---- instruction sets

// The instruction set says which of the processor's instructions the library uses.
//
// The library's hot functions are compiled several times, for narrow and for wide registers. It uses the widest version
// that the processor and the operating system support. Nobody has to choose: versions differ only in the width of their
// registers, so no answer, list, event, digest, count or box depends on the choice. Limit the set to measure, to
// compare, or if wide instructions slow down other work of the processor.
//
// The limit is one setting for a whole process: all threads, all worlds, all queries. There is no environment variable
// for it.
//
// Thread safety: all functions may be called from any thread, at any time once main() has begun.
//
// Example: verify/examples/how_do_i, limit_instructions().

// Lists instruction sets from narrow to wide. baseline is the set that the compiler compiles for: the instructions that
// every x86-64 has, unless build flags say otherwise. Other processors have only baseline. avx512 needs the parts F,
// BW, DQ and VL, and BMI2: for a processor that lacks one of them, avx2 is used.
enum class InstructionSet : std::uint8_t { baseline, avx2, avx512 };

// Returns the widest set that this processor and the operating system support, and for which the library has a version.
ECODS_API InstructionSet supported_instruction_set() noexcept;

// Returns the set in use: the supported one, unless it was limited.
ECODS_API InstructionSet instruction_set() noexcept;

// Uses nothing wider than `widest` from now on. If the processor does not support `widest`, the widest set that it
// supports is used; so limit_instruction_set(avx512) removes the limit. A call that is running in another thread may
// still use the set with which it began.
ECODS_API void limit_instruction_set(InstructionSet widest) noexcept;

ECODS_API std::ostream& operator<<(std::ostream& out, InstructionSet set);  // "baseline", "avx2", "avx512"

}  // namespace ecods
