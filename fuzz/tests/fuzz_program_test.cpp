// ecods_fuzz as its users run it: what goes wrong on purpose is found, shrunk, written, and seen again.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/programs/program_test.hpp"

namespace ecods::scenes {
namespace {

const std::string fuzz = ECODS_FUZZ_PROGRAM;
const std::string replay = ECODS_REPLAY_PROGRAM;

class FuzzProgramTest : public ProgramTest {
  protected:
    nlohmann::json campaign(const std::string& arguments, int status) {
        const auto result = run_program(fuzz, arguments + " --folder " + path("failures").string());
        EXPECT_EQ(result.status, status) << result.err;
        return nlohmann::json::parse(result.out);
    }
    // The failure of a campaign that has one.
    nlohmann::json failure_of(const std::string& arguments) {
        const auto summary = campaign(arguments, 1);
        EXPECT_EQ(summary["failures"].size(), 1U);
        return summary["failures"].at(0);
    }
    static std::string text_of(const std::string& file) {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    static long count(const std::string& text, const std::string& what) {
        long found = 0;
        for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++found;
        return found;
    }
};

TEST_F(FuzzProgramTest, AWrongAnswerBecomesAShortTrace) {
    const auto summary = campaign("--profile dense --seed 3 --runs 5 --canary", 1);
    ASSERT_EQ(summary["failures"].size(), 1U);
    const auto& failure = summary["failures"][0];
    EXPECT_EQ(failure["check"], "colliding pairs");
    EXPECT_EQ(failure["seed"], 3);
    EXPECT_EQ(summary["runs"], 1);
    const std::string file = failure["trace"];
    const std::string trace = text_of(file);
    EXPECT_EQ(count(trace, "\ncreate "), 2) << trace;
    EXPECT_EQ(count(trace, "\nupdate "), 1) << trace;
    EXPECT_EQ(count(trace, "\nset_"), 0) << trace;
    EXPECT_EQ(count(trace, "\nt "), count(trace, "\nmesh ")) << trace;
    EXPECT_EQ(count(trace, "\nnote check: colliding pairs\n"), 1) << trace;
    EXPECT_EQ(count(text_of(failure["picture"]), "\nf "), 2);

    EXPECT_EQ(run_program(replay, file).status, 0);
    EXPECT_EQ(run_program(fuzz, "--replay " + file).status, 0);
    const auto again = run_program(fuzz, "--canary --replay " + file);
    EXPECT_EQ(again.status, 1);
    EXPECT_NE(again.out.find("update 0: colliding pairs: expected"), std::string::npos) << again.out;
}

TEST_F(FuzzProgramTest, AWrongProofIsRefused) {
    const auto failure = failure_of("--profile tiny --seed 1 --runs 1 --canary proof");
    EXPECT_EQ(failure["check"], "check of a certificate");
    const std::string got = failure["got"];
    EXPECT_NE(got.find("refused: line"), std::string::npos) << got;
    EXPECT_EQ(count(text_of(failure["trace"]), "\nnote check: check of a certificate\n"), 1);
    const std::string kept = text_of(path("failures/tiny-1.certificates/certificates.txt"));
    EXPECT_GE(count(kept, "certificate 2\n"), 1) << got;
}

TEST_F(FuzzProgramTest, CertificatesAreCheckedWhereThereIsAChecker) {
    const auto checked = campaign("--profile tiny --seed 1 --runs 2", 0)["counts"]["certificates"];
    EXPECT_GT(checked["made"], 0);
    EXPECT_EQ(checked["accepted"], checked["made"]);
    for (const char* none : {"none", "\"\""}) {
        const auto without = run_program(fuzz, std::string("--profile tiny --seed 1 --runs 2 --checker ") + none);
        EXPECT_EQ(without.status, 0) << without.err;
        EXPECT_NE(without.err.find("certificates, not checked"), std::string::npos) << without.err;
        const auto counts = nlohmann::json::parse(without.out)["counts"]["certificates"];
        EXPECT_EQ(counts["made"], checked["made"]);
        EXPECT_FALSE(counts.contains("accepted"));
    }
    const auto unknown = run_program(fuzz, "--profile tiny --seed 1 --runs 2 --checker ./nosuch");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_NE(unknown.err.find("--checker ./nosuch: cannot be started"), std::string::npos) << unknown.err;
}

// The promises of a recipe are asked of the oracle; a case that breaks one is no crash, and no fault of the
// library.
TEST_F(FuzzProgramTest, AWrongRecipeIsNamed) {
    const auto failure = failure_of("--profile solids --seed 5 --runs 3 --canary recipe");
    EXPECT_EQ(failure["seed"], 5);
    EXPECT_EQ(failure["check"], "recipe");
    EXPECT_EQ(failure["expected"], "a bounds a solid");
    EXPECT_EQ(failure["got"].get<std::string>().find("open edge "), 0U) << failure["got"];
    EXPECT_FALSE(failure.contains("trace"));
}

TEST_F(FuzzProgramTest, ACrashIsAFailure) {
    const auto summary = campaign("--profile tiny --seed 2 --runs 5 --jobs 2 --canary crash", 1);
    ASSERT_GE(summary["failures"].size(), 1U);
    EXPECT_EQ(summary["failures"][0]["check"], "crash");
    const std::string trace = text_of(summary["failures"][0]["trace"]);
    EXPECT_EQ(count(trace, "\ncreate "), 2) << trace;
}

TEST_F(FuzzProgramTest, AHangIsAFailure) {
    const auto failure =
        failure_of("--profile tiny --seed 2 --runs 1 --canary hang --run-seconds 1 --shrink-seconds 0");
    EXPECT_EQ(failure["check"], "hang");
    EXPECT_FALSE(text_of(failure["trace"]).empty());
}

TEST_F(FuzzProgramTest, JobsDoNotMatter) {
    auto one = campaign("--profile motion --seed 4 --runs 8", 0);
    auto three = campaign("--profile motion --seed 4 --runs 8 --jobs 3", 0);
    for (const char* of_machine : {"seconds", "jobs"}) {
        one.erase(of_machine);
        three.erase(of_machine);
    }
    EXPECT_EQ(one, three);
    EXPECT_EQ(one["failures"].size(), 0U);
    EXPECT_EQ(one["runs"], 8);
}

TEST_F(FuzzProgramTest, HelpAndVersion) {
    expect_help_and_version(fuzz);
}

TEST_F(FuzzProgramTest, ProfilesAreListed) {
    const auto result = run_program(fuzz, "--list-profiles");
    EXPECT_EQ(result.status, 0);
    for (const char* name : {"tiny ", "stacks ", "pairs ", "motion ", "all "}) {
        EXPECT_NE(result.out.find(name), std::string::npos) << name;
    }
}

TEST_F(FuzzProgramTest, CommandsThatMakeNoSense) {
    EXPECT_EQ(run_program(fuzz, "--profile nothing").status, 2);
    EXPECT_EQ(run_program(fuzz, "--jobs 0").status, 2);
    EXPECT_EQ(run_program(fuzz, "--replay " + path("none.trace").string()).status, 2);
    EXPECT_EQ(run_program(fuzz, "--canary crush").status, 2);
}

}  // namespace
}  // namespace ecods::scenes
