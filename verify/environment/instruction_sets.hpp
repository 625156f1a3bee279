// Which of the library's versions a run asks, and asking each of them in one process.
//
// ECODS_INSTRUCTION_SET=baseline|avx2|avx512 makes a run of any test or program of this repository one on a processor
// that has no wider set. The library itself reads no variable: every main hands the limit on to it.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "ecods/export.hpp"

namespace ecods::environment {

constexpr const char* limit_variable = "ECODS_INSTRUCTION_SET";
constexpr InstructionSet all_instruction_sets[] = {InstructionSet::baseline, InstructionSet::avx2,
                                                   InstructionSet::avx512};

inline const char* name(InstructionSet set) noexcept {
    return set == InstructionSet::baseline ? "baseline" : set == InstructionSet::avx2 ? "avx2" : "avx512";
}

// The widest set that the processor supports and the variable, if there is one, permits. Throws std::invalid_argument
// when the variable names no set: a run that was to be limited and is not would prove nothing.
inline InstructionSet widest_instruction_set() {
    const char* limit = std::getenv(limit_variable);
    if (limit == nullptr) return supported_instruction_set();
    for (const InstructionSet set : all_instruction_sets) {
        if (limit == std::string(name(set))) return std::min(set, supported_instruction_set());
    }
    throw std::invalid_argument(std::string(limit_variable) + "=" + limit + ": baseline, avx2 or avx512 is expected");
}

// Hands the limit of the variable on to the library, at the beginning of main. Without the variable the library stays
// as it is, so that tests see what it does by itself. Throws as the above.
inline void limit_by_variable() {
    if (std::getenv(limit_variable) != nullptr) limit_instruction_set(widest_instruction_set());
}

// The same; where that throws, prints why and ends the program, with status 2.
inline void limit_by_variable_or_exit() {
    try {
        limit_by_variable();
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "%s\n", error.what());
        std::exit(2);
    }
}

// Those that this run may use, from narrow to wide.
inline std::vector<InstructionSet> supported_instruction_sets() {
    std::vector<InstructionSet> sets;
    for (const InstructionSet set : all_instruction_sets) {
        if (set <= widest_instruction_set()) sets.push_back(set);
    }
    return sets;
}

// As long as it lives, the library uses nothing wider; afterwards, what it used before.
class InstructionSetLimit {
  public:
    explicit InstructionSetLimit(InstructionSet widest) : before_(instruction_set()) { limit_instruction_set(widest); }
    ~InstructionSetLimit() { limit_instruction_set(before_); }
    InstructionSetLimit(const InstructionSetLimit&) = delete;
    InstructionSetLimit& operator=(const InstructionSetLimit&) = delete;

  private:
    InstructionSet before_;
};

}  // namespace ecods::environment
