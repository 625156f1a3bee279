// Prints, in one line, the instruction sets that tests and programs use in this run, from narrow to wide; the library
// is asked which it would use, so the line is what a limit led to. Exit status 2: ECODS_INSTRUCTION_SET names no set.
#include <cstdio>
#include <cstdlib>

#include "environment/instruction_sets.hpp"

int main() {
    using namespace ecods;
    environment::limit_by_variable_or_exit();
    std::printf("instruction sets of this run:");
    for (const InstructionSet set : environment::all_instruction_sets) {
        if (set <= instruction_set()) std::printf(" %s", environment::name(set));
    }
    const char* limit = std::getenv(environment::limit_variable);
    std::printf("; of the processor: up to %s; %s%s%s\n", environment::name(supported_instruction_set()),
                limit == nullptr ? "no limit" : environment::limit_variable, limit == nullptr ? "" : "=",
                limit == nullptr ? "" : limit);
}
