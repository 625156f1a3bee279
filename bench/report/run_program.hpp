// Runs another program, waits for it, and tells how it went.
#pragma once

#include <string>
#include <vector>

namespace ecods::bench {

struct ProgramResult {
    int status = 0;      // 127 when there is no such program
    std::string output;  // standard output and errors together
};

// Without a shell: arguments are passed as they are.
ProgramResult run_program(const std::vector<std::string>& arguments);

}  // namespace ecods::bench
