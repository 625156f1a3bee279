// Programs as their users run them: a process, its output and its exit status.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <string>

#include "file_test.hpp"

namespace ecods::scenes {

struct ProgramResult {
    int status = -1;
    std::string out;
    std::string err;
};

class ProgramTest : public FileTest {
  protected:
    ProgramResult run_program(const std::string& program, const std::string& arguments) const {
        const std::string errors = path("stderr.txt").string();
        const std::string command = program + " " + arguments + " 2>" + errors;
        ProgramResult result;
        std::FILE* pipe = popen(command.c_str(), "r");
        std::array<char, 4096> buffer{};
        for (std::size_t size = 0; (size = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
            result.out.append(buffer.data(), size);
        }
        const int status = pclose(pipe);
        result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        std::ostringstream text;
        text << std::ifstream(errors).rdbuf();
        result.err = text.str();
        return result;
    }
};

}  // namespace ecods::scenes
