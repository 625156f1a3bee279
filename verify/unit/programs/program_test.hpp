// Programs as their users run them: a process, its output and its exit status.
#pragma once

#include <filesystem>
#include <string>

#include "ecods/export.hpp"
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

    // A program that reads meshes says so when it may have a quarter of a gigabyte, and a file is one, or becomes more
    // as a document. (Sanitizers take more than that for themselves.)
    void expect_out_of_memory(const std::string& program) const {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        GTEST_SKIP() << "a sanitizer takes its own memory";
#endif
        const auto mesh = write("large.obj", "v 0 0 0\n");
        std::filesystem::resize_file(mesh, std::uintmax_t{1} << 30);
        std::string lists = "[[]";
        for (int i = 0; i < 5000000; ++i) lists += ",[]";
        for (const auto& file : {mesh, write("large.json", lists), write("large.gltf", lists)}) {
            const ProgramResult result = run_program("ulimit -v 262144 && " + program, file.string());
            EXPECT_EQ(result.status, 2);
            EXPECT_EQ(result.err,
                      std::filesystem::path(program).filename().string() + ": " + file.string() + ": out of memory\n");
        }
    }

    // A program that is told not to trust a scene refuses a mesh above the folder of the scene.
    void expect_untrusted_is_refused(const std::string& program) const {
        std::filesystem::create_directories(path("in"));
        write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const std::string file =
            write("in/s.json",
                  R"({"meshes": [{"name": "m", "file": "../t.obj"}], "bodies": [{"name": "b", "mesh": "m"}]})")
                .string();
        EXPECT_EQ(run_program(program, file).status, 0);
        const ProgramResult result = run_program(program, "--untrusted " + file);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.err, std::filesystem::path(program).filename().string() + ": " + file +
                                  ": meshes[0].file: names ../t.obj, which is outside of the folder of s.json; "
                                  "--untrusted\n");
        EXPECT_NE(run_program(program, "--help").out.find("--untrusted"), std::string::npos);
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
