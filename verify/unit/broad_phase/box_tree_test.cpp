#include "broad_phase/boxes/box_tree.hpp"

#include <gtest/gtest.h>

#include "unit/broad_phase/random_boxes.hpp"

namespace ecods::test::box_tree_test {
namespace {

constexpr std::size_t sizes[] = {1, 2, 7, 8, 9, 63, 64, 65, 100, 511, 513, 700};

struct Planted {
    std::vector<Aabb> boxes;
    std::vector<PackedBox> lines;
    BoxTree tree;

    Planted(std::size_t count, Spread spread, std::uint32_t seed = 1) : boxes(random_boxes(count, spread, seed)) {
        lines = lines_of(boxes);
        std::vector<TreeItem> items;
        for (SlotIndex slot = 0; slot < count; ++slot) items.push_back(tree_item(boxes[slot], slot));
        tree.build(items, lines);
    }
    std::uint32_t position_of(SlotIndex slot) const {
        std::uint32_t position = 0;
        while (tree.slot(position) != slot) ++position;
        return position;
    }
    void expect_all_found(std::size_t stride = 1) const {
        EXPECT_NO_THROW(tree.validate());
        BoxReach reach;
        for (std::size_t i = 0; i < boxes.size(); i += stride) {
            PackedBox line;
            make_packed_box(boxes[i], line);
            make_reach(line, reach);
            std::vector<SlotIndex> found;
            EXPECT_GT(tree.find(reach, found), 0u);
            EXPECT_EQ(sorted(found), overlapping_slots(line, lines)) << i;
        }
        std::vector<SlotPair> pairs;
        tree.join(tree, pairs);
        EXPECT_EQ(sorted(pairs), overlapping_slot_pairs(lines));
        expect_each_found(stride);
    }
    // Of many that are looked up at once, each finds what it finds alone, by as many tests.
    void expect_each_found(std::size_t stride) const {
        std::vector<BoxReach> reaches;
        std::vector<SlotPair> expected, found_pairs;
        std::uint64_t tests = 0;
        for (std::size_t i = 0; i < boxes.size(); i += stride) {
            const auto query = static_cast<std::uint32_t>(reaches.size());
            make_reach(lines_of({boxes[i]})[0], reaches.emplace_back());
            std::vector<SlotIndex> found;
            tests += tree.find(reaches.back(), found);
            for (const SlotIndex slot : found) expected.push_back({query, slot});
        }
        BlockVisits visits;
        std::vector<FoundBox> found;
        EXPECT_EQ(tree.find_each(reaches, visits, found), tests);
        for (const auto& [query, slot] : found) found_pairs.push_back({query, slot});
        EXPECT_EQ(sorted(found_pairs), sorted(expected));
        found.clear();
        EXPECT_EQ(tree.find_each({}, visits, found), 0u);
        EXPECT_TRUE(found.empty());
    }
};

TEST(BoxTree, FindsWhatOverlaps) {
    for (const Spread spread : all_spreads) {
        for (const std::size_t count : sizes) {
            SCOPED_TRACE(testing::Message() << count << " spread as " << static_cast<int>(spread));
            Planted(count, spread).expect_all_found(count / 50 + 1);
        }
    }
}

TEST(BoxTree, JoinsAnotherTree) {
    for (const Spread spread : all_spreads) {
        for (const std::size_t count : sizes) {
            const Planted a(300, spread), b(count, spread, 2);
            std::vector<SlotPair> expected, found;
            for (SlotIndex slot = 0; slot < a.lines.size(); ++slot) {
                for (const SlotIndex partner : overlapping_slots(a.lines[slot], b.lines)) {
                    expected.push_back({slot, partner});
                }
            }
            a.tree.join(b.tree, found);
            std::sort(found.begin(), found.end());
            EXPECT_EQ(found, expected);
            found.clear();
            b.tree.join(a.tree, found);
            for (SlotPair& pair : found) std::swap(pair[0], pair[1]);
            std::sort(found.begin(), found.end());
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(BoxTree, BoxesChangeAndGo) {
    Planted planted(300, Spread::cube);
    const std::vector<Aabb> others = random_boxes(300, Spread::cube, 2);
    for (SlotIndex slot = 0; slot < 300; slot += 3) {
        planted.boxes[slot] = others[slot];
        make_packed_box(others[slot], planted.lines[slot]);
        planted.tree.set(planted.position_of(slot), planted.lines[slot]);
    }
    planted.expect_all_found(7);
    for (SlotIndex slot = 0; slot < 300; slot += 2) {
        planted.lines[slot] = {};
        planted.tree.set(planted.position_of(slot), {});
    }
    EXPECT_EQ(planted.tree.alive_count(), 150u);
    EXPECT_EQ(planted.tree.size(), 300u);
    planted.expect_all_found(7);
}

TEST(BoxTree, ARefittedTreeIsRightForAnyBoxes) {
    Planted planted(300, Spread::cube);
    planted.boxes = random_boxes(300, Spread::decades, 5);
    planted.lines = lines_of(planted.boxes);
    planted.tree.refit(planted.lines);
    planted.expect_all_found(7);
}

// Where a box was taken out close by, another is put; else nothing changes.
TEST(BoxTree, ABoxTakesTheNearbyPlaceOfAnother) {
    Planted planted(600, Spread::cube);
    std::uint32_t position = 0;
    const SlotIndex mover = 5;
    const TreeItem item = tree_item(planted.boxes[mover], mover);
    EXPECT_FALSE(planted.tree.insert(item, planted.lines[mover], position)) << "it is full";
    const std::uint32_t old_position = planted.position_of(mover);
    planted.tree.set(old_position, {});
    EXPECT_EQ(planted.tree.alive_count(), 599u);
    ASSERT_TRUE(planted.tree.insert(item, planted.lines[mover], position)) << "its own place is free";
    EXPECT_EQ(position, old_position);
    EXPECT_EQ(planted.tree.alive_count(), 600u);
    planted.expect_all_found(11);

    planted.tree.set(old_position, {});
    planted.lines[mover] = {};
    const Aabb outside = {.min = Vec3::Constant(1e6), .max = Vec3::Constant(1e6)};
    EXPECT_FALSE(planted.tree.insert(tree_item(outside, mover), lines_of({outside})[0], position));
    planted.expect_all_found(11);
}

TEST(BoxTree, ASearchCostsLittle) {
    const Planted planted(50'000, Spread::cube);
    std::uint64_t tests = 0;
    BoxReach reach;
    std::vector<SlotIndex> found;
    for (std::size_t i = 0; i < 1000; ++i) {
        make_reach(planted.lines[i], reach);
        tests += planted.tree.find(reach, found);
    }
    EXPECT_LT(tests / 1000, 300u) << "of 50,000";
    std::vector<SlotPair> pairs;
    EXPECT_LT(planted.tree.join(planted.tree, pairs) / 50'000, 200u);
}

}  // namespace
}  // namespace ecods::test::box_tree_test
