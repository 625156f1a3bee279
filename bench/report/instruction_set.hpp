// Which instructions the program may use.
#pragma once

#include <string>

namespace ecods::bench {

// Replaces this process by itself with GLIBC_TUNABLES set such that the C library, and every choice that asks it, sees
// no instructions beyond the set: "avx2" or "baseline". Does nothing for "native", or when that is the set already.
// Nothing is hidden from code that asks the processor itself, as the resolvers that compilers make do: ECoDS and Embree
// among it, which run the same versions as ever. Throws std::runtime_error when the program cannot be started again.
void start_again_with(const std::string& instruction_set, char** arguments);

// What is hidden, or "native".
std::string instruction_set_in_use();

}  // namespace ecods::bench
