// Which instructions the engines may use.
#pragma once

#include <string>

namespace ecods::bench {

// Limits ECoDS, Embree (which follows ECoDS: engines/broad_embree.cpp) and the C library to a set of instructions,
// "avx2" or "baseline"; does nothing for "native". The other engines are built for the baseline, whatever is asked for.
// For the C library (its copying and mathematics) this process is replaced by itself with GLIBC_TUNABLES set, unless
// they are so already. Throws std::runtime_error when the program cannot be started again.
void use_instruction_set(const std::string& name, char** arguments);

// What was asked for, and what ECoDS uses then.
std::string instruction_set_in_use();

}  // namespace ecods::bench
