// Programs as their users run them: a process, its output and its exit status.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

#include "ecods/version.hpp"
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

    // What every program does when it is asked about itself.
    void expect_help_and_version(const std::string& program) const {
        const ProgramResult help = run_program(program, "--help");
        EXPECT_EQ(help.status, 0);
        EXPECT_EQ(help.err, "");
        EXPECT_NE(help.out.find("--version"), std::string::npos) << help.out;
        for (const char each : help.out) EXPECT_TRUE(each == '\n' || (each >= ' ' && each <= '~')) << int{each};
        const ProgramResult version = run_program(program, "--version");
        EXPECT_EQ(version.status, 0);
        EXPECT_EQ(version.err, "");
        EXPECT_EQ(version.out, std::filesystem::path(program).filename().string() + " " +
                                   std::to_string(ECODS_VERSION_MAJOR) + "." + std::to_string(ECODS_VERSION_MINOR) +
                                   "." + std::to_string(ECODS_VERSION_PATCH) + "\n");
        const ProgramResult misused = run_program(program, "--no-such-option");
        EXPECT_EQ(misused.status, 2);
        EXPECT_EQ(misused.out, "");
    }
};

}  // namespace ecods::scenes
