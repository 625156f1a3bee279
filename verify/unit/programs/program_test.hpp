// Programs as their users run them: a process, its output and its exit status.
#pragma once

#include <filesystem>
#include <string>

#include "ecods/version.hpp"
#include "file_test.hpp"
#include "process/program.hpp"

namespace ecods::scenes {

using process::ProgramResult;

class ProgramTest : public FileTest {
  protected:
    // Arguments are a shell's.
    ProgramResult run_program(const std::string& program, const std::string& arguments) const {
        return process::run_program({"sh", "-c", program + " " + arguments});
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
