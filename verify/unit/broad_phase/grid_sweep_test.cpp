#include "broad_phase/scratch/grid_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "broad_phase/scratch/list_pairs.hpp"
#include "unit/broad_phase/lockstep.hpp"
#include "unit/broad_phase/random_boxes.hpp"

namespace ecods::test::grid_sweep_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<SlotPair> found_by(GridSweep& search, const std::vector<PackedBox>& lines) {
    std::vector<SlotPair> found;
    search.find_pairs(lines, found);
    return sorted(found);
}
void expect_right(const std::vector<PackedBox>& lines) {
    GridSweep search;
    EXPECT_EQ(found_by(search, lines), overlapping_slot_pairs(lines));
}

TEST(GridSweep, FindsThePairsOfAllKindsOfBoxes) {
    for (const Spread spread : all_spreads) {
        for (const std::size_t count : {0u, 1u, 2u, 3u, 9u, 64u, 700u, 2500u}) {
            if (spread == Spread::one_place && count > 700) continue;
            expect_right(lines_of(random_boxes(count, spread)));
        }
    }
}

// The memory of one search is that of the next, of more boxes or fewer.
TEST(GridSweep, RepeatsAndLeavesNothingBehind) {
    GridSweep search;
    for (const std::size_t count : {900u, 40u, 0u, 1500u, 900u}) {
        const std::vector<PackedBox> lines = lines_of(random_boxes(count, Spread::cube, 7));
        EXPECT_EQ(found_by(search, lines), overlapping_slot_pairs(lines));
    }
}

TEST(GridSweep, AppendsAndCounts) {
    const std::vector<PackedBox> lines = lines_of({make_cube(0, 0, 0), make_cube(1, 0, 0), make_cube(3, 0, 0)});
    std::vector<SlotPair> found = {{7, 8}};
    EXPECT_GT(GridSweep().find_pairs(lines, found), 0u);
    EXPECT_EQ(sorted(found), (std::vector<SlotPair>{{0, 1}, {7, 8}}));
}

TEST(GridSweep, EmptyLinesOverlapNone) {
    std::vector<PackedBox> lines = lines_of(random_boxes(500, Spread::cube));
    for (std::size_t slot = 0; slot < lines.size(); slot += 3) lines[slot] = {};
    expect_right(lines);
    expect_right(std::vector<PackedBox>(100));
}

// All ways in which the ends of two or three intervals of four values can lie, on each axis.
TEST(GridSweep, DecidesAllWaysToTouch) {
    constexpr double values[] = {-infinity, -0x1p-1074, 0.0, 0x1p-1074, 1.0, infinity};
    std::vector<std::pair<double, double>> intervals;
    for (const double from : values) {
        for (const double to : values) {
            if (from <= to) intervals.emplace_back(from, to);
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const auto& [a, b] : intervals) {
            for (const auto& [c, d] : intervals) {
                expect_right(lines_of({make_interval(axis, a, b), make_interval(axis, c, d)}));
                // Among others, so that ranks tell something.
                std::vector<Aabb> boxes = random_boxes(60, Spread::cube);
                boxes.push_back(make_interval(axis, a, b));
                boxes.push_back(make_interval(axis, c, d));
                if (a == values[0] && d == values[4]) expect_right(lines_of(boxes));
            }
        }
    }
}

// Ends that differ by one unit in the last place have one rank.
TEST(GridSweep, NeighbouringDoublesAreToldApart) {
    std::vector<Aabb> boxes = random_boxes(300, Spread::cube);
    for (const double x : {0.0, 1.0, -3.0}) {
        for (const double by : {std::nextafter(x, -100), x, std::nextafter(x, 100)}) {
            boxes.push_back(make_box(x - 1, x, -1, 1, -1, 1));
            boxes.push_back(make_box(by, by + 1, -1, 1, -1, 1));
            boxes.push_back(make_box(-1, 1, by, by + 1, -1, 1));
            boxes.push_back(make_box(-1, 1, -1, 1, by, by + 1));
        }
    }
    expect_right(lines_of(boxes));
}

TEST(GridSweep, SizesAndPlacesOfAllMagnitudes) {
    scenes::Random random(3);
    std::vector<Aabb> boxes;
    for (int i = 0; i < 1500; ++i) {
        Aabb box;
        for (int axis = 0; axis < 3; ++axis) {
            const double x = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(2040)) - 1020);
            box.min[axis] = i % 7 == axis ? -infinity : x;
            box.max[axis] = i % 5 == axis ? infinity : x + std::abs(x) * random.uniform(0, 2);
        }
        boxes.push_back(box);
    }
    expect_right(lines_of(boxes));
}

// Many boxes that reach all cells, where a sample of every so many boxes does not see them.
TEST(GridSweep, LargeBoxesThatNoSampleSees) {
    std::vector<Aabb> boxes = random_boxes(4000, Spread::cube);
    for (std::size_t i = 1; i < boxes.size(); i += 8) boxes[i] = make_cube(0, 0, 0, 1000);
    const std::vector<PackedBox> lines = lines_of(boxes);
    GridSweep search;
    EXPECT_EQ(found_by(search, lines), overlapping_slot_pairs(lines));
    EXPECT_LT(search.bytes(), 4000u * 1000);
}

// A thousand places far apart, each with boxes side by side: of one place all have the same ranks.
TEST(GridSweep, PlacesFarApartAreNotQuadratic) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 20'000; ++i) {
        const double place = i % 2 == 0 ? 0 : 0x1p60;
        boxes.push_back(make_cube(place + (i % 2 == 0 ? 2.0 * (i / 2) : 1024.0 * (i / 2)), 0, 0));
    }
    const std::vector<PackedBox> lines = lines_of(boxes);
    std::vector<SlotPair> found;
    const std::uint64_t tests = GridSweep().find_pairs(lines, found);
    EXPECT_LT(tests, 1000u * 20'000);
    std::vector<SlotPair> expected;
    for (SlotIndex i = 0; i + 2 < 200; ++i) {
        for (SlotIndex k = i + 1; k < 200; ++k) {
            if (overlap(lines[i], lines[k])) expected.push_back({i, k});
        }
    }
    std::erase_if(found, [](const SlotPair& pair) { return pair[0] >= 200 || pair[1] >= 200; });
    EXPECT_EQ(sorted(found), expected);
}

TEST(GridSweep, WhatAllOverlapIsFoundByTheSweep) {
    std::vector<SlotPair> found;
    const std::uint64_t tests =
        GridSweep().find_pairs(std::vector<PackedBox>(3000, lines_of({make_cube(0, 0, 0)})[0]), found);
    EXPECT_EQ(found.size(), 3000u * 2999 / 2);
    EXPECT_LT(tests, 2 * found.size());
}

TEST(GridSweep, RanksNeverDescend) {
    scenes::Random random(5);
    std::vector<double> values = {-infinity, -1e300, -1, -0x1p-1074, 0, 0x1p-1074, 1, 1e300, infinity};
    for (int i = 0; i < 2000; ++i) values.push_back(random.uniform(-20, 20));
    std::sort(values.begin(), values.end());
    for (const auto& [low, high] :
         {std::pair(-10.0, 10.0), {0.0, 0.0}, {0.0, -0.0}, {0.0, 0x1p-1070}, {-1e308, 1e308}, {5.0, 1e9}}) {
        RankMap map;
        map.set(0, low, high);
        std::int32_t last = 0;
        for (const double value : values) {
            const std::int32_t rank = map.at(KeyLanes{key_of(value), 0, 0, 0})[0];
            EXPECT_GE(rank, last);
            EXPECT_LT(rank, RankMap::rank_end);
            last = rank;
        }
    }
}

TEST(ListPairs, AscendAndAreComplete) {
    ProxyPairs list = {{9, 9}};
    ListingMemory memory;
    list_pairs({}, 4, list, memory);
    EXPECT_TRUE(list.empty());
    const std::vector<SlotPair> found = {{3, 1}, {0, 3}, {2, 1}, {2, 0}, {4, 1}, {0, 1}};
    list_pairs(found, 5, list, memory);
    EXPECT_EQ(list, (Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {1, 4}}));
}

}  // namespace
}  // namespace ecods::test::grid_sweep_test
