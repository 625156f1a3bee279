// What turns of engines have in common: how long they are timed for, and which of their answers the oracle judges.
#pragma once

#include <chrono>
#include <cstddef>

#include "harness/stopwatch.hpp"

namespace ecods::bench {

// For a turn, by the clock on the wall: an engine that takes longer hangs.
inline constexpr std::chrono::seconds turn_limit{300};

// Timed passes over the queries go on for so long. A few queries of a microsecond each, after another engine had the
// core, would measure how long it takes to wake it.
constexpr double turn_us_min = 20000;

template <class Pass>
double microseconds_a_pass(const Pass& pass) {
    double us = 0;
    std::size_t passes = 0;
    const Stopwatch watch;
    while (us < turn_us_min) {
        pass();
        ++passes;
        us = watch.nanoseconds() / 1000;
    }
    return us / static_cast<double>(passes);
}

// Asks untimed, by `ask(i)` of i = 0, 1, ...: a pass over so many queries, or as much of it as that time allows.
template <class Ask>
void wake(std::size_t query_count, const Ask& ask) {
    const Stopwatch watch;
    for (std::size_t i = 0; i < query_count && watch.nanoseconds() / 1000 < turn_us_min; ++i) ask(i);
}

// Whether query i of n is one of `chosen` that are spread evenly.
inline bool is_chosen(std::size_t i, std::size_t n, std::size_t chosen) {
    return (i + 1) * chosen / n != i * chosen / n;
}

}  // namespace ecods::bench
