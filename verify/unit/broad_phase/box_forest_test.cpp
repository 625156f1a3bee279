#include "broad_phase/boxes/box_forest.hpp"

#include <gtest/gtest.h>

#include "ecods/error.hpp"
#include "unit/broad_phase/random_boxes.hpp"

namespace ecods::test::box_forest_test {
namespace {

struct PlantedForest {
    std::vector<Aabb> boxes;
    std::vector<PackedBox> lines;
    BoxForest forest;

    PlantedForest(std::size_t count, Spread spread) : boxes(random_boxes(count, spread)), lines(lines_of(boxes)) {
        std::vector<BoxForest::Item> items;
        for (SlotIndex slot = 0; slot < count; ++slot) items.push_back(BoxForest::make_item(boxes[slot], slot));
        forest.build(items, lines);
    }
    void remove(SlotIndex slot) {
        forest.remove(slot);
        lines[slot] = {};
    }
    BoxForest::Item place(SlotIndex slot, const Aabb& box) {
        if (slot >= lines.size()) {
            boxes.resize(slot + 1);
            lines.resize(slot + 1);
        }
        boxes[slot] = box;
        make_packed_box(box, lines[slot]);
        return BoxForest::make_item(box, slot);
    }
    std::uint64_t expect_all_found() const {
        EXPECT_NO_THROW(forest.validate(lines));
        BoxReach reach;
        for (std::size_t i = 0; i < lines.size(); i += 13) {
            make_reach(lines[i], reach);
            std::vector<SlotIndex> found;
            forest.find(reach, found);
            EXPECT_EQ(sorted(found), overlapping_slots(lines[i], lines));
        }
        std::vector<SlotPair> pairs;
        const std::uint64_t tests = forest.find_pairs(pairs);
        EXPECT_EQ(sorted(pairs), overlapping_slot_pairs(lines));
        return tests;
    }
};

TEST(BoxForest, FindsWhatOverlaps) {
    for (const Spread spread : all_spreads) {
        for (const std::size_t count : {1, 9, 70, 800}) PlantedForest(count, spread).expect_all_found();
    }
}

TEST(BoxForest, AnEmptyOneFindsNothing) {
    BoxForest forest;
    forest.build({}, {});
    std::vector<SlotPair> pairs;
    forest.find_pairs(pairs);
    EXPECT_TRUE(pairs.empty());
    EXPECT_NO_THROW(forest.validate({}));
    EXPECT_EQ(forest.unsorted_count(), 0u);
}

TEST(BoxForest, BoxesComeChangeAndGo) {
    for (const Spread spread : all_spreads) {
        PlantedForest planted(700, spread);
        const std::vector<Aabb> others = random_boxes(2000, spread, 7);
        scenes::Random random(3);
        SlotIndex next = 700;
        for (int round = 0; round < 12; ++round) {
            std::vector<BoxForest::Item> newcomers;
            for (int i = 0; i < 20; ++i) {
                const SlotIndex slot = random.below(next);
                planted.remove(slot);
                const auto is_same = [slot](const BoxForest::Item& item) { return item.item.slot == slot; };
                if (std::erase_if(newcomers, is_same) > 0 || i % 3 == 0) continue;
                newcomers.push_back(planted.place(slot, others[slot]));
            }
            for (int i = 0; i < 5; ++i, ++next) newcomers.push_back(planted.place(next, others[next]));
            planted.forest.add(newcomers, planted.lines);
            for (SlotIndex slot = round; slot < next; slot += 29) {
                if (planted.lines[slot].is_empty()) continue;
                planted.place(slot, others[slot + 1]);
                planted.forest.set(slot, planted.lines[slot]);
            }
            planted.expect_all_found();
        }
        planted.forest.refit(planted.lines);
        planted.expect_all_found();
    }
}

// Where boxes jump among each other, those that came take the places of those that went.
TEST(BoxForest, MostThatJumpAmongOthersAreNoNewcomers) {
    PlantedForest planted(2000, Spread::cube);
    const std::vector<Aabb> others = random_boxes(2000, Spread::cube, 7);
    for (SlotIndex first = 0; first < 2000; first += 100) {
        std::vector<BoxForest::Item> jumped;
        for (SlotIndex slot = first; slot < first + 100; ++slot) planted.remove(slot);
        for (SlotIndex slot = first; slot < first + 100; ++slot) jumped.push_back(planted.place(slot, others[slot]));
        planted.forest.add(jumped, planted.lines);
    }
    EXPECT_LT(planted.forest.unsorted_count(), 500u);
    planted.expect_all_found();
}

// One large box in each block of small ones would make every search a search of everything.
TEST(BoxForest, LargeBoxesDoNotSpoilTheTreeOfSmallOnes) {
    std::vector<Aabb> boxes = random_boxes(4000, Spread::cube);
    for (std::size_t i = 0; i < boxes.size(); i += 20) boxes[i].max = boxes[i].min + Vec3::Constant(30);
    const std::vector<PackedBox> lines = lines_of(boxes);
    std::vector<BoxForest::Item> items;
    for (SlotIndex slot = 0; slot < boxes.size(); ++slot) items.push_back(BoxForest::make_item(boxes[slot], slot));
    BoxForest forest;
    forest.build(items, lines);
    std::vector<SlotPair> pairs;
    const std::uint64_t tests = forest.find_pairs(pairs);
    EXPECT_EQ(sorted(pairs), overlapping_slot_pairs(lines));
    EXPECT_LT(tests, 200 * boxes.size() + 12 * pairs.size());
}

TEST(BoxForest, ValidateSeesAWrongBox) {
    PlantedForest planted(50, Spread::cube);
    planted.lines[17] = planted.lines[18];
    planted.lines[17].ends[0] -= 1;
    EXPECT_THROW(planted.forest.validate(planted.lines), BrokenInvariant);
}

}  // namespace
}  // namespace ecods::test::box_forest_test
