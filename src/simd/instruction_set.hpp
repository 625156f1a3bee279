// The instruction set in use (ecods/instruction_set.hpp) is read here by the dispatcher.
#pragma once

#include <atomic>

#include "ecods/instruction_set.hpp"

namespace ecods {

// The baseline until the library's objects of namespace scope have been initialised.
extern std::atomic<InstructionSet> instruction_set_in_use;

inline InstructionSet read_instruction_set() noexcept {
    return instruction_set_in_use.load(std::memory_order_relaxed);
}

}  // namespace ecods
