// ecods_bench as its users run it.
#include <gtest/gtest.h>

#include <filesystem>

#include "unit/programs/program_test.hpp"

namespace ecods::bench {
namespace {

class BenchProgramTest : public scenes::ProgramTest {
  protected:
    scenes::ProgramResult run(const std::string& arguments) const {
        return run_program(ECODS_BENCH_PROGRAM, arguments);
    }
};

TEST_F(BenchProgramTest, HelpAndVersion) {
    expect_help_and_version(ECODS_BENCH_PROGRAM);
}

TEST_F(BenchProgramTest, UnknownSuitesAndEnginesAreErrors) {
    EXPECT_EQ(run("--quick --suite nosuch").status, 2);
    const auto unknown = run("--quick --engines nosuch");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.out, "");
    EXPECT_NE(unknown.err.find("--engines nosuch: there is no such engine"), std::string::npos) << unknown.err;
    EXPECT_EQ(run("--quick --suite narrow --engines 'Embree rtcCollide'").status, 2) << "an engine of another suite";
}

TEST_F(BenchProgramTest, SaysWhetherEcodsWasAsked) {
    const auto peers = run("--quick --suite hard_cases --engines 'FCL OBBRSS'");
    EXPECT_EQ(peers.status, 0);
    EXPECT_NE(peers.out.find("ECoDS was not asked"), std::string::npos) << peers.out;
    EXPECT_EQ(peers.out.find("Every answer"), std::string::npos) << peers.out;
    const auto own = run("--quick --suite hard_cases --engines ECoDS");
    EXPECT_EQ(own.status, 0);
    EXPECT_NE(own.out.find("Every answer of ECoDS is the oracle's"), std::string::npos) << own.out;
}

TEST_F(BenchProgramTest, AReportIsWrittenWhereItIsAskedFor) {
    const std::filesystem::path report = path("report");
    const auto quick = run("--quick --suite hard_cases --engines ECoDS --report " + report.string());
    EXPECT_EQ(quick.status, 0) << quick.err;
    EXPECT_TRUE(std::filesystem::exists(report / "index.html"));
    EXPECT_NE(quick.out.find("report: " + (report / "index.html").string()), std::string::npos) << quick.out;
    EXPECT_EQ(run("--quick --suite hard_cases --engines ECoDS").out.find("report: "), std::string::npos);
}

}  // namespace
}  // namespace ecods::bench
