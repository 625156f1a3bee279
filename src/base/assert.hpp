// Preconditions, checked in builds for debugging.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace ecods {

// Prints which condition does not hold, and where it was asked for, and aborts.
[[noreturn]] inline void fail_assertion(const char* condition, const char* file, int line) noexcept {
    std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, condition);
    std::abort();
}

}  // namespace ecods

// ECODS_ASSERT(condition) states what a caller must keep. Where NDEBUG is not defined, a condition that does not hold
// ends the program with file, line and the condition; otherwise the condition is compiled and never evaluated. Input
// from outside the library is answered by typed errors (ecods/error.hpp), never by this.
#ifdef NDEBUG
#define ECODS_ASSERT(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#else
#define ECODS_ASSERT(condition) \
    ((condition) ? static_cast<void>(0) : ::ecods::fail_assertion(#condition, __FILE__, __LINE__))
#endif
