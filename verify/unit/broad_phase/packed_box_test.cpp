#include "broad_phase/boxes/packed_box.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test::packed_box_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Aabb samples[] = {
    make_box(0, 0, 0, 0, 0, 0),
    make_box(-0.0, 0, 0, 1, -1, -0.0),
    make_box(-3, -2, 2, 3, -5, 5),
    make_box(-infinity, infinity, -infinity, 0, 0, infinity),
    make_box(-1e308, 1e308, 0x1p-1074, 0x1p-1073, -0x1p-1074, 0),
    make_box(-2, -2, 0, 1, -1, 0),
    make_box(infinity, infinity, 0, 1, 0, 1),
};

PackedBox line_of(const Aabb& box) {
    PackedBox line;
    make_packed_box(box, line);
    return line;
}

TEST(PackedBox, IsTheKeysOfTheBox) {
    for (const Aabb& box : samples) {
        EXPECT_EQ(line_of(box), packed_box(key_box(box)));
        EXPECT_EQ(key_box(line_of(box)), key_box(box));
        EXPECT_FALSE(line_of(box).is_empty());
    }
    EXPECT_TRUE(PackedBox{}.is_empty());
}

TEST(PackedBox, LanesOverlapAsTheNumbersDo) {
    for (const Aabb& a : samples) {
        for (const Aabb& b : samples) {
            BoxReach reach;
            make_reach(line_of(b), reach);
            const bool expected = (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
            EXPECT_EQ(overlaps(line_of(a), reach), expected);
            EXPECT_EQ(overlap(line_of(a), line_of(b)), expected);
            const bool is_inside = (a.min.array() <= b.min.array()).all() && (b.max.array() <= a.max.array()).all();
            EXPECT_EQ(contains(line_of(a), line_of(b)), is_inside);
        }
    }
}

TEST(PackedBox, TheEmptyBoxOverlapsNothing) {
    BoxReach reach;
    for (const Aabb& box : samples) {
        make_reach(line_of(box), reach);
        EXPECT_FALSE(overlaps(PackedBox{}, reach));
        make_reach(PackedBox{}, reach);
        EXPECT_FALSE(overlaps(line_of(box), reach));
        EXPECT_FALSE(contains(PackedBox{}, line_of(box)));
    }
    EXPECT_FALSE(overlaps(PackedBox{}, reach));
}

TEST(PackedBox, AnEnlargedOneContainsBothAndNoMore) {
    PackedBox line = line_of(make_box(0, 1, 0, 1, 0, 1));
    enlarge(line, PackedBox{});
    EXPECT_EQ(line, line_of(make_box(0, 1, 0, 1, 0, 1)));
    enlarge(line, line_of(make_box(3, 4, -2, -1, 0.5, 0.5)));
    EXPECT_EQ(line, line_of(make_box(0, 4, -2, 1, 0, 1)));
}

TEST(BoxBlock, HoldsEightBoxesOrFewer) {
    BoxBlock block;
    EXPECT_TRUE(block.bounds().is_empty());
    PackedBox bounds;
    for (std::size_t i = 0; i < std::size(samples); ++i) {
        EXPECT_TRUE(block.get(i).is_empty());
        block.set(i, line_of(samples[i]));
        EXPECT_EQ(block.get(i), line_of(samples[i]));
        enlarge(bounds, block.get(i));
        EXPECT_EQ(block.bounds(), bounds);
    }
    for (const Aabb& box : samples) {
        BoxReach reach;
        make_reach(line_of(box), reach);
        std::uint32_t expected = 0;
        for (std::size_t i = 0; i < std::size(samples); ++i) {
            if (overlap(line_of(box), line_of(samples[i]))) expected |= 1u << i;
        }
        EXPECT_EQ(overlapping(block, reach), expected);
    }
}

}  // namespace
}  // namespace ecods::test::packed_box_test
