// Asking the library with each of its versions, in one process.
#pragma once

#include <vector>

#include "ecods/instruction_set.hpp"

namespace ecods::environment {

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

// Those that this processor supports, from narrow to wide.
inline std::vector<InstructionSet> supported_instruction_sets() {
    std::vector<InstructionSet> sets;
    for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
        if (set <= supported_instruction_set()) sets.push_back(set);
    }
    return sets;
}

inline const char* name(InstructionSet set) noexcept {
    return set == InstructionSet::baseline ? "baseline" : set == InstructionSet::avx2 ? "avx2" : "avx512";
}

}  // namespace ecods::environment
