#include "broad_phase/boxes/coarse_box.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test::coarse_box_test {
namespace {

// Those next to each other differ in the lower half of their digits, or in the upper one, or in the sign.
constexpr double coordinates[] = {-std::numeric_limits<double>::infinity(),
                                  -1e308,
                                  -1 - 0x1p-20,
                                  -1 - 0x1p-52,
                                  -1,
                                  -0x1p-1074,
                                  0,
                                  0.5,
                                  1 - 0x1p-53,
                                  1,
                                  1 + 0x1p-52,
                                  1 + 0x1p-21,
                                  1 + 0x1p-20,
                                  2,
                                  0x1.fffffp+10,
                                  0x1p+11,
                                  std::numeric_limits<double>::infinity()};

CoarseBox coarse_box(const PackedBox& line) {
    CoarseBox coarse;
    make_coarse_box(line, coarse);
    return coarse;
}

// Of all intervals between those coordinates, on one axis; on the others, all overlap for certain.
std::vector<PackedBox> lines_along(std::size_t axis) {
    std::vector<PackedBox> lines;
    for (const double low : coordinates) {
        for (const double high : coordinates) {
            if (high < low) continue;
            Aabb box = make_box(-1, 1, -1, 1, -1, 1);
            box.min[static_cast<Eigen::Index>(axis)] = low;
            box.max[static_cast<Eigen::Index>(axis)] = high;
            lines.push_back(packed_box(key_box(box)));
        }
    }
    return lines;
}

TEST(CoarseBox, DecidesAsTheBoxDoesWhereItIsNotInDoubt) {
    std::size_t doubts = 0, decided = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<PackedBox> lines = lines_along(axis);
        for (const PackedBox& a : lines) {
            for (const PackedBox& b : lines) {
                const auto [are_apart, are_in_doubt] = coarse_overlap(coarse_box(a), coarse_box(b));
                const auto halves_are_equal = [&](std::size_t end) {
                    return a.ends[end] >> 32 == ~b.ends[end < 3 ? end + 3 : end - 3] >> 32;
                };
                ASSERT_EQ(are_in_doubt, halves_are_equal(axis) || halves_are_equal(axis + 3));
                ++(are_in_doubt ? doubts : decided);
                ASSERT_TRUE(are_in_doubt || are_apart != overlap(a, b));
            }
        }
    }
    EXPECT_GT(doubts, 1000u);
    EXPECT_GT(decided, 10000u);
}

TEST(CoarseBox, MarkedIsInDoubtWithAll) {
    for (const PackedBox& a : lines_along(1)) {
        for (const PackedBox& b : {packed_box(key_box(make_box(-3, -2, 0, 1, 0, 1))), PackedBox{}, a}) {
            CoarseBox marked = coarse_box(a), other = coarse_box(b);
            marked.mark();
            EXPECT_TRUE(coarse_overlap(marked, other).are_in_doubt);
            EXPECT_TRUE(coarse_overlap(other, marked).are_in_doubt);
            other.mark();
            EXPECT_TRUE(coarse_overlap(marked, other).are_in_doubt);
            marked.unmark();
            EXPECT_EQ(marked, coarse_box(a));
        }
    }
}

TEST(CoarseBox, TheEmptyBoxIsApartFromAll) {
    EXPECT_EQ(coarse_box(PackedBox{}), CoarseBox{});
    for (const PackedBox& line : lines_along(2)) {
        const auto [are_apart, are_in_doubt] = coarse_overlap(CoarseBox{}, coarse_box(line));
        EXPECT_TRUE(are_apart || are_in_doubt);
    }
}

}  // namespace
}  // namespace ecods::test::coarse_box_test
