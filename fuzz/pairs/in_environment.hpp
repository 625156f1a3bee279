// An answer asked for with one instruction set and in one floating-point environment, each drawn at random.
#pragma once

#include <optional>
#include <string>

#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "judge/distance_truth.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// What `ask` answers; `where` says in which environment.
template <class Ask>
std::optional<judge::Wrong> ask_in_environment(scenes::Random& random, std::string& where, const Ask& ask) {
    const auto& mode = environment::float_modes[random.below(environment::float_modes.size())];
    const auto sets = environment::supported_instruction_sets();
    const InstructionSet set = sets[random.below(static_cast<std::uint32_t>(sets.size()))];
    where = std::string(mode.name) + ", " + environment::name(set);
    const environment::InstructionSetLimit limit(set);
    const environment::InFloatMode in_mode(mode);
    return ask();
}

}  // namespace ecods::fuzz
