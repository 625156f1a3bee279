// ecods_bench as its users run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

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

// A suite begins and ends with a line each, also where nobody looks at a terminal.
TEST_F(BenchProgramTest, TheMainJobIsShortAndSaysHowFarItIs) {
    const auto main = run("--quick --main");
    EXPECT_EQ(main.status, 0) << main.err;
    EXPECT_NE(main.err.find("suite 1 of 4: narrow ...\n"), std::string::npos) << main.err;
    EXPECT_NE(main.err.find("suite 4 of 4: rooms: "), std::string::npos) << main.err;
    EXPECT_NE(main.out.find("Every answer of ECoDS is the oracle's"), std::string::npos) << main.out;
    EXPECT_NE(main.out.find("no time in these tables is a speed"), std::string::npos) << main.out;
    for (const char* title :
         {"Two meshes: do they touch?", "Boxes that move: which overlap?", "Ever more ships in the same room",
          "Ever more ships at the same density", "Many moving meshes: which collide?"})
        EXPECT_NE(main.out.find(title), std::string::npos) << title;
    EXPECT_LT(std::count(main.out.begin(), main.out.end(), '\n'), 80) << main.out;
    EXPECT_EQ(run("--main --suite narrow").status, 2);
    EXPECT_EQ(run("--main --long").status, 2);
}

TEST_F(BenchProgramTest, TheScriptSaysWhatItRuns) {
    const auto help = run_program(ECODS_BENCH_RUN, "--help");
    EXPECT_EQ(help.status, 0) << help.err;
    EXPECT_NE(help.out.find("bench/run --all"), std::string::npos) << help.out;
}

// The page of results that are saved here: the headline comes first, charts are drawn in it, and it names no other
// file.
TEST_F(BenchProgramTest, APageIsDrawnAgainFromSavedResults) {
    const std::filesystem::path report = path("report"), sample = path("sample");
    const auto drawn = run("--from " ECODS_BENCH_RESULTS "/AMD-EPYC-2026-11-26.csv --report " + report.string() +
                           " --sample " + sample.string());
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    std::ifstream in(report / "index.html");
    const std::string html{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const std::size_t chart = html.find("<figure class=\"chart\">"), tables = html.find("In three tables</h2>"),
                      losses = html.find("Where ECoDS loses</h2>"), rest = html.find("Engines on all scenes</h2>");
    EXPECT_TRUE(chart < tables && tables < losses && losses < rest && rest != std::string::npos);
    EXPECT_NE(html.find("<title>Bullet GImpact: "), std::string::npos) << "values when one points at a mark";
    EXPECT_NE(html.find("prefers-color-scheme: dark"), std::string::npos);
    EXPECT_EQ(html.find("rgb("), std::string::npos) << "a colour that does not change in the dark";
    EXPECT_EQ(html.find("src=\"http"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(sample / "summary.svg"));
    EXPECT_TRUE(std::filesystem::exists(sample / "sign-map.png"));
    EXPECT_EQ(run("--from " ECODS_BENCH_RESULTS "/README.md --report " + report.string()).status, 2);
}

}  // namespace
}  // namespace ecods::bench
