// Asks questions from Python: in the memory of the calling thread, and without the interpreter's lock.
#pragma once

#include <pybind11/pybind11.h>

#include "ecods/intersection.hpp"
#include "ecods/shape.hpp"

namespace ecods::python {

// Returns the query memory of the calling thread; it grows to the size that the thread's largest query needed.
inline QueryMemory& thread_memory() {
    thread_local QueryMemory memory;
    return memory;
}

// Returns question(memory), called without the interpreter's lock.
template <class Question>
auto ask(Question question) {
    const pybind11::gil_scoped_release release;
    return question(thread_memory());
}

// Asks with a witness, which other threads may be using: the question works on a copy.
template <class Question>
auto ask(PairWitness* witness, Question question) {
    PairWitness known = witness == nullptr ? PairWitness{} : *witness;
    auto answer = ask([&](QueryMemory& memory) { return question(memory, known); });
    if (witness != nullptr) *witness = known;
    return answer;
}

// Return functions for pybind11 that ask question(given..., memory), and question(given..., memory, witness).
template <class... Given, class Question>
auto asked(Question question) {
    return [question](const Given&... given) { return ask([&](auto& memory) { return question(given..., memory); }); };
}
template <class... Given, class Question>
auto asked_with_witness(Question question) {
    return [question](const Given&... given, PairWitness* known) {
        return ask(known, [&](auto& memory, auto& witness) { return question(given..., memory, witness); });
    };
}

// A callable that selects the overload of the library's function `name` by its arguments.
#define ECODS_QUESTION(name) [](auto&... given) { return name(given...); }

}  // namespace ecods::python
