#include "broad_phase/sweep/endpoints_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::endpoints_sort_test {
namespace {

struct Fixture {
    ProxyTable table;
    BoxHistory boxes;
    EndpointList ends;
    ProxyPairs began, ended;
    SortState state{.boxes = boxes, .began = began, .ended = ended, .swaps_max = 1'000'000};

    // Unit intervals at 0, 10, 20, ... on axis 0.
    explicit Fixture(ProxyIndex count) {
        for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
            table.add(proxy, test::make_interval(0, 10.0 * proxy, 10.0 * proxy + 1));
        }
        boxes.advance(table.collect().added, table);
        boxes.settle(table.collect().added);
        table.settle();
        for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
            ends.push_back(min_end(boxes.now(proxy), proxy, 0));
            ends.push_back(max_end(boxes.now(proxy), proxy, 0));
        }
    }

    bool sort(const std::vector<ProxyIndex>& moved) {
        boxes.advance(moved, table);
        return sort_axis(ends, 0, moved, state);
    }
};

TEST(SortAxis, AtOneCoordinateAMinimumIsBeforeAnyMaximumThenProxiesCount) {
    std::vector<Endpoint> ends = {{5, 1 | Endpoint::max_bit}, {5, 0 | Endpoint::max_bit}, {5, 2}, {4, 7}, {5, 1}};
    std::sort(ends.begin(), ends.end());
    EXPECT_EQ(ends[0].proxy(), 7u);
    EXPECT_FALSE(ends[1].is_max());
    EXPECT_EQ(ends[1].proxy(), 1u);
    EXPECT_EQ(ends[2].proxy(), 2u);
    EXPECT_TRUE(ends[3].is_max());
    EXPECT_EQ(ends[3].proxy(), 0u);
    EXPECT_EQ(ends[4].proxy(), 1u);
}

// One swap for each two ends that changed order, the fewest that can be.
TEST(SortAxis, OneBoxPassingAnotherCostsFourSwapsAndTouchesNothingElse) {
    for (const ProxyIndex count : {3u, 100u}) {  // the whole list, and the moved ends alone
        Fixture fixture(count);
        fixture.table.move(0, test::make_interval(0, 12, 13));
        EXPECT_TRUE(fixture.sort({0}));
        EXPECT_EQ(fixture.state.swaps, 4u);
        EXPECT_TRUE(std::is_sorted(fixture.ends.begin(), fixture.ends.end()));
        EXPECT_TRUE(fixture.began.empty()) << "a box that jumped over another is not judged on the way";
        EXPECT_TRUE(fixture.ended.empty());
    }
}

TEST(SortAxis, ABoxThatGrowsOverAllBeginsAllPairs) {
    Fixture fixture(100);
    fixture.table.move(50, test::make_interval(0, -1e9, 1e9));
    EXPECT_TRUE(fixture.sort({50}));
    EXPECT_TRUE(std::is_sorted(fixture.ends.begin(), fixture.ends.end()));
    EXPECT_EQ(fixture.began.size(), 99u);
    EXPECT_EQ(fixture.state.swaps, 198u);
}

TEST(SortAxis, MovesInBothDirectionsAtOnce) {
    Fixture fixture(200);
    fixture.table.move(3, test::make_interval(0, 1500, 1700));
    fixture.table.move(190, test::make_interval(0, -5, 30));
    fixture.table.move(4, test::make_interval(0, 40, 41.5));
    EXPECT_TRUE(fixture.sort({190, 3, 4}));
    EXPECT_TRUE(std::is_sorted(fixture.ends.begin(), fixture.ends.end()));
}

TEST(SortAxis, GivingUpLosesNoEnd) {
    for (const ProxyIndex count : {10u, 100u}) {
        Fixture fixture(count);
        fixture.state.swaps_max = 3;
        fixture.table.move(count - 1, test::make_interval(0, -2, -1));
        EXPECT_FALSE(fixture.sort({count - 1}));
        sort_axis_from_scratch(fixture.ends, 0, fixture.boxes);
        EXPECT_TRUE(std::is_sorted(fixture.ends.begin(), fixture.ends.end()));
        std::vector<std::uint32_t> tags;
        for (const Endpoint& end : fixture.ends) tags.push_back(end.tag);
        std::sort(tags.begin(), tags.end());
        EXPECT_EQ(std::adjacent_find(tags.begin(), tags.end()), tags.end());
        EXPECT_EQ(tags.size(), 2u * count);
    }
}

}  // namespace
}  // namespace ecods::endpoints_sort_test
