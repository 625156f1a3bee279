#include "report/place_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace ecods::bench {
namespace {

Panel panel(const std::vector<std::pair<double, double>>& points) {
    Panel panel;
    panel.x = {.title = "x", .is_logarithmic = true, .low = 1, .high = 100};
    panel.y = {.title = "y", .low = 0, .high = 4};
    for (const auto& [x, y] : points) panel.curves.push_back({"FCL OBBRSS", {{x, y, "text"}}});
    return panel;
}

std::vector<std::string> alignments(const Panel& panel) {
    std::vector<std::string> result;
    for (const NamePlace& place : place_names(panel, 560, 330)) result.emplace_back(place.alignment);
    return result;
}

using Names = std::vector<std::string>;

TEST(PlaceNames, RightOfAMarkWhereThereIsRoom) {
    EXPECT_EQ(alignments(panel({{3, 2}})), Names{"left"});
    EXPECT_EQ(alignments(panel({{90, 2}})), Names{"right"});
}

TEST(PlaceNames, MarksAtOnePlaceHaveNamesOnAllSides) {
    const Panel four = panel({{10, 2}, {10, 2}, {10, 2}, {10, 2}});
    EXPECT_EQ(alignments(four), (Names{"left", "right", "center", "center"}));
    const auto names = place_names(four, 560, 330);
    EXPECT_GT(names[2].up, 0);
    EXPECT_LT(names[3].up, 0);
}

TEST(PlaceNames, NoNameCoversAMark) {
    EXPECT_EQ(alignments(panel({{10, 2}, {14, 2}})), (Names{"right", "left"}));
}

TEST(PlaceNames, CurvesWithoutPointsHaveAPlaceAllTheSame) {
    Panel one = panel({{10, 2}});
    one.curves.insert(one.curves.begin(), Curve{"nothing", {}});
    EXPECT_EQ(alignments(one), (Names{"center", "left"}));
}

}  // namespace
}  // namespace ecods::bench
