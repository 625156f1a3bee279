// What turns of engines have in common: how long they are timed for, and which of their answers the oracle judges.
#pragma once

#include <cstddef>
#include <vector>

#include "harness/stopwatch.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

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

// Asks untimed for a tenth of that, once at least: `ask(i)` of i = 0, 1, ...
template <class Ask>
void wake(const Ask& ask) {
    const Stopwatch watch;
    std::size_t i = 0;
    do ask(i++);
    while (watch.nanoseconds() / 1000 < turn_us_min / 10);
}

// Whether query i of n is one of `chosen` that are spread evenly.
inline bool is_chosen(std::size_t i, std::size_t n, std::size_t chosen) {
    return (i + 1) * chosen / n != i * chosen / n;
}

// Each child has its turn, then each again, as often as said, so that a change of the machine's pace meets all of them.
// `note(i, repetition, outcome)` takes child i's; repetition 0 is the one that is not timed, others count from 1.
template <class Note>
void take_turns(std::vector<process::Contained>& children, std::size_t repetition_count, const Note& note) {
    for (std::size_t repetition = 0; repetition <= repetition_count; ++repetition)
        for (std::size_t i = 0; i < children.size(); ++i) note(i, repetition, children[i].run());
}

}  // namespace ecods::bench
