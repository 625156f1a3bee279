// ecods_replay as its users run it.
#include <nlohmann/json.hpp>

#include "program_test.hpp"
#include "trace_of_cubes.hpp"

namespace ecods::scenes {
namespace {

class Replay : public ProgramTest {
  protected:
    ProgramResult run(const std::string& arguments) const { return run_program(ECODS_REPLAY_PROGRAM, arguments); }
};

TEST_F(Replay, ATraceRunsAsTraced) {
    const std::string file = write("good.txt", trace_of_cubes()).string();
    for (const char* options : {"", " --validate", " --broad-phase brute_force"}) {
        const auto result = run(file + options);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out, file + ": 8 calls, 3 updates, 2 bodies, 0 colliding pairs: as traced\n");
        EXPECT_EQ(result.err, "");
    }
}

TEST_F(Replay, HelpAndVersion) {
    expect_help_and_version(ECODS_REPLAY_PROGRAM);
}

TEST_F(Replay, TheFirstFrameThatDiffersIsNamed) {
    std::string text = trace_of_cubes();
    const std::size_t at = text.find("0x1p-2");  // the second frame's pose
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 6, "0x1p-3");
    const std::string file = write("other.txt", text).string();
    const auto result = run(file);
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.out.find("DIFFERS  update 1, call 5, line "), std::string::npos) << result.out;
    const auto json = nlohmann::json::parse(run(file + " --json").out);
    EXPECT_EQ(json["difference"]["update"], 1);
    EXPECT_EQ(json["difference"]["call"], 5);
    EXPECT_EQ(json["updates"], 1);
}

TEST_F(Replay, WhatCannotBeReadIsStatusTwoWithItsLine) {
    EXPECT_EQ(run(path("missing.txt").string()).status, 2);
    EXPECT_EQ(run("").status, 2);
    EXPECT_EQ(run("--what").status, 2);
    EXPECT_EQ(run("--help").status, 0);
    EXPECT_EQ(run(path("").string()).status, 2) << "a folder";
    const auto result = run(write("bad.txt", trace_of_cubes() + "set_pose 7.0\n").string());
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("line 53: there is no such body"), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
    const auto shape = run(write("shape.txt", "ecods-trace 2\nworld brute_force 0\nshape 1 3 any\n").string());
    EXPECT_EQ(shape.status, 2);
    EXPECT_NE(shape.err.find("line 3: a shape of kind 3"), std::string::npos) << shape.err;
}

// One line of a gigabyte, in a process that may have a quarter of it. (Sanitizers take more than that for themselves.)
TEST_F(Replay, OutOfMemorySaysSo) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer takes its own memory";
#endif
    const auto file = write("large.txt", "ecods-trace 2\nworld brute_force 0\nnote ");
    std::filesystem::resize_file(file, std::uintmax_t{1} << 30);
    const auto result = run_program("ulimit -v 262144 && " ECODS_REPLAY_PROGRAM, file.string());
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "ecods_replay: " + file.string() + ": out of memory\n");
}

}  // namespace
}  // namespace ecods::scenes
