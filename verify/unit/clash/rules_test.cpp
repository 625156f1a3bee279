// Name patterns, groups and rules.
#include "programs/clash/rules.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ecods::clash {
namespace {

TEST(ClashRules, PatternsMatch) {
    EXPECT_TRUE(matches("", ""));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_TRUE(matches("wall*", "wall A"));
    EXPECT_TRUE(matches("*a*b*", "xxabab"));
    EXPECT_TRUE(matches("?all", "wall"));
    EXPECT_TRUE(matches("*.obj", "a.obj.obj"));
    EXPECT_FALSE(matches("", "x"));
    EXPECT_FALSE(matches("?", ""));
    EXPECT_FALSE(matches("wall", "wall A"));
    EXPECT_FALSE(matches("*a*b", "xxaba"));
    // Not exponential.
    EXPECT_FALSE(matches("*a*a*a*a*a*a*a*a*a*a*a*a*b", std::string(5000, 'a')));
}

std::vector<Part> parts_named(const std::vector<std::string>& names) {
    std::vector<Part> parts;
    for (const std::string& name : names) parts.push_back({.name = name, .file = "dir/" + name + ".obj", .group = ""});
    return parts;
}

// Which of the pairs 01, 02, 12 are judged.
std::string judged(const Rules& rules) {
    auto parts = parts_named({"duct", "pipe", "wall"});
    set_groups(parts, rules);
    const PairFilter filter(parts, rules);
    std::string pairs;
    for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
        EXPECT_EQ(filter.is_judged(a, b), filter.is_judged(b, a));
        if (filter.is_judged(a, b)) pairs += std::to_string(a) + std::to_string(b) + " ";
    }
    return pairs;
}

TEST(ClashRules, GroupsAndIgnoredPairs) {
    EXPECT_EQ(judged({}), "01 02 12 ");
    EXPECT_EQ(judged({.a = {"wall"}}), "02 12 ");
    EXPECT_EQ(judged({.b = {"wall"}}), "02 12 ");
    EXPECT_EQ(judged({.a = {"duct", "pipe"}, .b = {"wall"}}), "02 12 ");
    EXPECT_EQ(judged({.a = {"*"}, .b = {"dir/p*"}}), "01 12 ");
    EXPECT_EQ(judged({.a = {"nothing"}}), "");
    EXPECT_EQ(judged({.ignored = {{"wall", "*"}}}), "01 ");
    EXPECT_EQ(judged({.ignored = {{"wall", "duct"}, {"pipe", "pipe"}}}), "01 12 ");
}

}  // namespace
}  // namespace ecods::clash
