#include "bvh/walks/walk_one.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ecods::walk_one_test {
namespace {

// Numbers below 8^3, by their digits: a node is the digits of its numbers from the left.
struct Digits {
    struct Node {
        std::uint32_t digit_count;
        std::uint32_t value;
    };
    using Stack = FixedStack<Node, 2 * 7 + 1>;

    Node root() const { return {0, 0}; }
    bool is_bottom(const Node& node) const { return node.digit_count == 2; }
    Node child(const Node& node, std::uint32_t lane) const { return {node.digit_count + 1, node.value * 8 + lane}; }
};

// The numbers that a walk comes to, with the lanes of each node that `lanes` holds.
template <LaneOrder order = LaneOrder::last_first>
std::vector<std::uint32_t> walk(std::uint32_t lanes, std::size_t count_max, int& asked) {
    std::vector<std::uint32_t> found;
    asked = 0;
    Digits::Stack stack;
    walk_one<order>(
        Digits{}, stack,
        [&](const Digits::Node&) {
            ++asked;
            return lanes;
        },
        [&](const Digits::Node& node, std::uint32_t bottom_lanes) {
            EXPECT_EQ(bottom_lanes, lanes);
            found.push_back(node.value);
            return found.size() < count_max;
        });
    return found;
}

TEST(WalkOne, FollowsTheLanesOfTheBound) {
    int asked;
    EXPECT_EQ(walk(0b10000001, 100, asked), (std::vector<std::uint32_t>{077, 070, 007, 000}));
    EXPECT_EQ(asked, 1 + 2 + 4);
    EXPECT_TRUE(walk(0, 100, asked).empty());
    EXPECT_EQ(asked, 1);
}

TEST(WalkOne, BeginsWithTheFirstLaneWhereAsked) {
    int asked;
    EXPECT_EQ(walk<LaneOrder::first_first>(0b10000001, 100, asked), (std::vector<std::uint32_t>{000, 007, 070, 077}));
    EXPECT_EQ(walk<LaneOrder::first_first>(0b110, 1, asked), (std::vector<std::uint32_t>{011}));
    EXPECT_EQ(asked, 1 + 1 + 1);
}

TEST(WalkOne, AllLanesOfAllNodesFitTheStack) {
    int asked;
    EXPECT_EQ(walk(0xff, 100, asked).size(), 64u);
    EXPECT_EQ(asked, 1 + 8 + 64);
}

TEST(WalkOne, EndsWhenTheResultSaysSo) {
    int asked;
    EXPECT_EQ(walk(0xff, 3, asked).size(), 3u);
    EXPECT_EQ(asked, 1 + 1 + 3);
}

}  // namespace
}  // namespace ecods::walk_one_test
