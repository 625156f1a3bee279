// How a target says that something is wrong: a fuzzer saves the input that made it end.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace ecods::fuzz {

inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

}  // namespace ecods::fuzz
