#include "suites/compare_builds.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ecods::bench {
namespace {

std::vector<OwnSample> samples(double ns, std::uint64_t tests, const std::string& answers = "a") {
    std::vector<OwnSample> list;
    for (int i = 0; i < 6; ++i) list.push_back({ns + i, {{"box tests", tests}, {"swaps", 3}}, answers});
    return list;
}

TEST(CompareBuilds, EqualBuildsAreTheSame) {
    const BuildComparison result = compare_samples({{"boxes", samples(100, 7), samples(100, 7)}});
    EXPECT_TRUE(result.is_same);
    EXPECT_EQ(result.table.rows.at(0),
              (std::vector<std::string>{"boxes", "equal", "equal", "102.5", "102.5", "1.000", "0", ""}));
}

TEST(CompareBuilds, ACountThatChangedIsNamed) {
    const BuildComparison result = compare_samples({{"boxes", samples(100, 7), samples(100, 6)}});
    EXPECT_FALSE(result.is_same);
    EXPECT_EQ(result.table.rows.at(0).at(2), "box tests 7 -> 6");
}

TEST(CompareBuilds, AnAnswerThatChangedIsNamed) {
    const BuildComparison result = compare_samples({{"boxes", samples(100, 7), samples(100, 7, "b")}});
    EXPECT_FALSE(result.is_same);
    EXPECT_EQ(result.table.rows.at(0).at(1), "DIFFERENT");
}

TEST(CompareBuilds, TimesAreJudgedByTheirRatiosButDoNotFail) {
    const BuildComparison result = compare_samples({{"boxes", samples(100, 7), samples(120, 7)},
                                                    {"more", samples(100, 7), samples(80, 7)},
                                                    {"same", samples(1000, 7), samples(1010, 7)}});
    EXPECT_TRUE(result.is_same);
    EXPECT_EQ(result.table.rows.at(0).back(), "slower");
    EXPECT_EQ(result.table.rows.at(1).back(), "faster");
    EXPECT_EQ(result.table.rows.at(2).back(), "");
    EXPECT_NEAR(result.ratio_max, 1.195, 0.01);
    EXPECT_EQ(result.slowest, "boxes");
}

TEST(CompareBuilds, WhatOnlyOneBuildKnowsIsNoDifference) {
    std::vector<OwnSample> newer = samples(100, 7);
    newer.front().counts["new count"] = 5;
    const BuildComparison result = compare_samples({{"boxes", samples(100, 7), newer}, {"more", {}, newer}});
    EXPECT_TRUE(result.is_same);
    EXPECT_EQ(result.table.rows.at(1).at(1), "only new");
}

TEST(CompareBuilds, LinesAreReadAsWritten) {
    const OwnSample sample{12.5, {{"swaps", 18446744073709551615u}}, "0123"};
    const OwnSample read = parse_sample(to_line(sample));
    EXPECT_EQ(read.ns, sample.ns);
    EXPECT_EQ(read.counts, sample.counts);
    EXPECT_EQ(read.answers, sample.answers);
    EXPECT_THROW(parse_sample("usage: ..."), std::runtime_error);
    EXPECT_THROW(parse_sample("{\"ns\": \"fast\"}"), std::runtime_error);
    EXPECT_THROW(parse_names("{}"), std::runtime_error);
}

}  // namespace
}  // namespace ecods::bench
