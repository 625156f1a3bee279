// Asks questions from Python without the interpreter's lock, in the memory that the library keeps for each thread.
#pragma once

#include <pybind11/pybind11.h>

#include "ecods/ask.hpp"

namespace ecods::python {

// Returns question(), called without the interpreter's lock.
template <class Question>
auto ask(Question question) {
    const pybind11::gil_scoped_release release;
    return question();
}

// Returns question(ask), called in the same way, with an Ask of the witness, if there is one. Other threads may be
// using the witness: the question works on a copy.
template <class Question>
auto ask(PairWitness* witness, Question question) {
    if (witness == nullptr) return ask([&] { return question(Ask()); });
    PairWitness known = *witness;
    auto answer = ask([&] { return question(Ask(known)); });
    *witness = known;
    return answer;
}

// Return functions for pybind11 that ask question(given...), and question(given..., ask) with a witness.
template <class... Given, class Question>
auto asked(Question question) {
    return [question](const Given&... given) { return ask([&] { return question(given...); }); };
}
template <class... Given, class Question>
auto asked_with_witness(Question question) {
    return [question](const Given&... given, PairWitness* witness) {
        return ask(witness, [&](const Ask& how) { return question(given..., how); });
    };
}

// A callable that selects the overload of the library's function `name` by its arguments.
#define ECODS_QUESTION(name) [](const auto&... given) { return name(given...); }

}  // namespace ecods::python
