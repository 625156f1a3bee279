// How a target says that something is wrong: a fuzzer saves the input that made it end.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace ecods::fuzz {

inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

// The same for an answer of the judge, which is nothing or what is wrong.
template <class Wrong>
void require_right(const std::optional<Wrong>& wrong) {
    const std::string what = wrong ? wrong->question + ": expected " + wrong->expected + ", got " + wrong->got : "";
    require(!wrong, what.c_str());
}

}  // namespace ecods::fuzz
