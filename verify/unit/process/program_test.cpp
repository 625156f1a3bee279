#include "process/program.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ecods::process {
namespace {

TEST(RunProgram, OutputErrorsAndStatus) {
    const ProgramResult result = run_program({"sh", "-c", "echo out; echo err >&2; exit 5"});
    EXPECT_EQ(result.status, 5);
    EXPECT_EQ(result.out, "out\n");
    EXPECT_EQ(result.err, "err\n");
    EXPECT_EQ(result.text(), "out\nerr\n");
}

TEST(RunProgram, ArgumentsAreNoShells) {
    EXPECT_EQ(run_program({"echo", "$HOME  'x'"}).out, "$HOME  'x'\n");
}

TEST(RunProgram, LongOutputOfBothKindsAtOnce) {
    const ProgramResult result =
        run_program({"sh", "-c", "head -c 300000 /dev/zero >&2; head -c 300000 /dev/zero; cat"});
    EXPECT_EQ(result.status, 0) << "the input is empty";
    EXPECT_EQ(result.out.size(), 300'000U);
    EXPECT_EQ(result.err.size(), 300'000U);
}

TEST(RunProgram, OneThatDoesNotStartOrIsKilled) {
    const ProgramResult missing = run_program({"/no/such/program"});
    EXPECT_EQ(missing.status, 127);
    EXPECT_EQ(missing.err, "/no/such/program cannot be started");
    EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}).status, 128 + 9);
}

TEST(Conversation, LineByLine) {
    Conversation cat({"cat"});
    EXPECT_EQ(cat.ask("one"), "one");
    EXPECT_EQ(cat.ask("two"), "two");
    Conversation echo({"echo", "once"});
    EXPECT_EQ(echo.read_line(), "once");
    EXPECT_THROW(echo.read_line(), std::runtime_error);
    EXPECT_THROW(echo.ask("again"), std::runtime_error);
    EXPECT_THROW(Conversation({"/no/such/program"}), std::runtime_error);
}

}  // namespace
}  // namespace ecods::process
