// One question asked with every instruction set and in every floating-point environment.
#pragma once

#include <cfenv>
#include <stdexcept>
#include <string>

#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"

namespace ecods::environment {

// Calls `look(answer, where)`, in the usual environment, with what `ask()` answers in each: rounding modes, flush to
// zero, and the instruction sets that this run may use. Throws std::logic_error if the rounding mode is another then.
template <class Ask, class Look>
void in_each_environment(const Ask& ask, const Look& look) {
    const auto ask_in = [&](const FloatMode& mode) {
        const InFloatMode in_mode(mode);
        auto answer = ask();
        if (std::fegetround() != mode.rounding) throw std::logic_error("a question left another rounding mode");
        return answer;
    };
    for (const InstructionSet set : supported_instruction_sets()) {
        const InstructionSetLimit limit(set);
        for (const FloatMode& mode : float_modes) {
            const auto answer = ask_in(mode);
            look(answer, std::string(name(set)) + ", " + mode.name);
        }
    }
}

}  // namespace ecods::environment
