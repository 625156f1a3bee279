// ecods_fuzz_engine as its users run it; a program of its own, since only who builds the other engines has it.
#include <gtest/gtest.h>

#include "unit/programs/program_test.hpp"

namespace ecods::scenes {
namespace {

class FuzzEngineProgramTest : public ProgramTest {};

TEST_F(FuzzEngineProgramTest, HelpVersionAndUnknownEngines) {
    const std::string engines = ECODS_FUZZ_ENGINE_PROGRAM;
    expect_help_and_version(engines);
    EXPECT_EQ(run_program(engines, "--engine nosuch").status, 2);
    EXPECT_EQ(run_program(ECODS_FUZZ_PROGRAM, "--engine nosuch").status, 2);
}

}  // namespace
}  // namespace ecods::scenes
