#include "suites/asked.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ecods::bench {
namespace {

const std::vector<Suite> suites = {{"narrow", nullptr, {{"ECoDS", true}, {"FCL OBB", false}, {"FCL OBBRSS", false}}},
                                   {"broad", nullptr, {{"ECoDS, automatic", true}, {"Bullet", false}}},
                                   {"rooms", nullptr},
                                   {"memory", nullptr, {{"ECoDS", true}, {"Bullet", false}}, false}};
const std::vector<std::string> all_names = {"narrow", "broad", "rooms", "memory"};

SuiteOptions wanting(const std::vector<std::string>& engines) {
    SuiteOptions options;
    options.engines = engines;
    return options;
}

std::vector<std::string> names_of(const std::vector<Suite>& asked) {
    std::vector<std::string> names;
    for (const Suite& suite : asked) names.push_back(suite.name);
    return names;
}

std::string error_of(const std::vector<std::string>& names, const std::vector<std::string>& engines) {
    try {
        asked_suites(suites, names, wanting(engines));
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(Asked, AllSuitesUnlessEnginesAreNamed) {
    EXPECT_EQ(names_of(asked_suites(suites, all_names, {})), all_names);
    const std::vector<std::string> two = {"memory", "broad"};
    EXPECT_EQ(names_of(asked_suites(suites, two, {})), (std::vector<std::string>{"broad", "memory"}));
}

TEST(Asked, SuitesWithoutAWantedEngineAreLeftOut) {
    EXPECT_EQ(names_of(asked_suites(suites, all_names, wanting({"FCL"}))),
              (std::vector<std::string>{"narrow", "rooms"}));
    EXPECT_EQ(names_of(asked_suites(suites, all_names, wanting({"Bullet"}))),
              (std::vector<std::string>{"broad", "rooms", "memory"}));
}

TEST(Asked, AnUnknownEngineIsAnError) {
    EXPECT_EQ(error_of(all_names, {"ECoDS", "nosuch"}),
              "--engines nosuch: there is no such engine in the suites that are asked for; they have: Bullet; ECoDS; "
              "ECoDS, automatic; FCL OBB; FCL OBBRSS");
    EXPECT_NE(error_of({"narrow"}, {"Bullet"}), "") << "no suite that is asked for has it";
    EXPECT_EQ(error_of({"rooms"}, {"ECoDS"}), "--engines ECoDS: the suites that are asked for choose no engines");
    EXPECT_EQ(error_of(all_names, {"OBBRSS"}), "") << "a part of a name";
}

TEST(Asked, TheVerdictSaysWhereEcodsWasNotAsked) {
    const auto verdict_of = [](const std::vector<std::string>& names, const std::vector<std::string>& engines) {
        const SuiteOptions options = wanting(engines);
        return verdict(asked_suites(suites, names, options), options, true);
    };
    const std::string right = "Every answer of ECoDS is the oracle's: 0 false negatives, 0 false positives.";
    EXPECT_EQ(verdict_of(all_names, {}), right);
    EXPECT_EQ(verdict_of({"narrow", "memory"}, {"ECoDS"}), right);
    EXPECT_EQ(verdict_of({"narrow", "broad"}, {"ECoDS, automatic", "FCL OBB"}),
              right + " It was not asked in: narrow.");
    EXPECT_EQ(verdict_of({"narrow"}, {"FCL"}), "ECoDS was not asked: no answer of it was judged.");
    EXPECT_EQ(verdict_of({"memory"}, {}), "ECoDS was not asked: no answer of it was judged.");
    EXPECT_EQ(verdict(suites, {}, false), "ECoDS ANSWERED WRONGLY: see the tables.");
}

}  // namespace
}  // namespace ecods::bench
