// Asks the library questions from Python, without the interpreter's lock.
#pragma once

#include <pybind11/pybind11.h>

#include "ecods/ask.hpp"

namespace ecods::python {

// Returns question(). Releases the interpreter's lock while it runs.
template <class Question>
auto ask(Question question) {
    const pybind11::gil_scoped_release release;
    return question();
}

// Returns question(ask). Releases the interpreter's lock while it runs. If there is a witness, `ask` has a copy of it,
// which is stored to *witness afterwards, because other threads may use the witness meanwhile.
template <class Question>
auto ask(PairWitness* witness, Question question) {
    if (witness == nullptr) return ask([&] { return question(Ask()); });
    PairWitness known = *witness;
    auto answer = ask([&] { return question(Ask(known)); });
    *witness = known;
    return answer;
}

// Return functions for pybind11 to bind. The function of asked() returns question(given...). The function of
// asked_with_witness() takes a witness as a further argument and returns question(given..., ask), where `ask` has the
// witness. Both run without the interpreter's lock.
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

// Makes a callable that calls the library's function `name`; the arguments select the overload.
#define ECODS_QUESTION(name) [](const auto&... given) { return name(given...); }

}  // namespace ecods::python
