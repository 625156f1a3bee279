// read_instruction_set returns the instruction set in use (ecods/export.hpp), for the dispatcher.
#pragma once

#include <atomic>

#include "ecods/export.hpp"

namespace ecods {

// Holds the instruction set in use. It is the baseline until the library's static objects have been initialised.
extern std::atomic<InstructionSet> instruction_set_in_use;

inline InstructionSet read_instruction_set() noexcept {
    return instruction_set_in_use.load(std::memory_order_relaxed);
}

}  // namespace ecods
