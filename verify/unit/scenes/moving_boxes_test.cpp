#include "scenes/moving_boxes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "oracle/oracle.hpp"

namespace ecods::scenes {
namespace {

constexpr BoxLayout layouts[] = {BoxLayout::dense, BoxLayout::sparse, BoxLayout::pile, BoxLayout::decades};

template <class Check>
void for_each_box(const MovingBoxes& boxes, const Check& check) {
    for (const Aabb& box : boxes.boxes) check(box);
    for (const std::vector<BoxMove>& frame : boxes.frames)
        for (const BoxMove& move : frame) check(move.box);
}

TEST(MovingBoxes, AreTheSameInFloat) {
    for (const BoxLayout layout : layouts) {
        const MovingBoxes boxes = moving_boxes({.layout = layout, .motion = BoxMotion::teleport, .count = 3000});
        for_each_box(boxes, [](const Aabb& box) {
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(static_cast<double>(static_cast<float>(box.min[axis])), box.min[axis]);
                EXPECT_EQ(static_cast<double>(static_cast<float>(box.max[axis])), box.max[axis]);
                EXPECT_LT(box.min[axis], box.max[axis]);
            }
        });
    }
}

// Two lists of partners for each pair. Boxes at the walls have fewer partners, so the mean lies below what is told.
TEST(MovingBoxes, HaveAboutAsManyPartnersAsTold) {
    for (const BoxLayout layout : layouts) {
        const MovingBoxes boxes = moving_boxes({.layout = layout, .count = 4000, .frame_count = 1});
        const double partners = 2.0 * static_cast<double>(oracle::overlapping_boxes(boxes.boxes).size()) / 4000;
        const double told = layout == BoxLayout::sparse ? 0.3 : 5;
        EXPECT_GT(partners, 0.75 * told) << boxes.name;
        EXPECT_LT(partners, 1.15 * told) << boxes.name;
    }
}

TEST(MovingBoxes, SizesSpanThreeDecades) {
    double smallest = 1e9, largest = 0;
    for_each_box(moving_boxes({.layout = BoxLayout::decades, .frame_count = 1}), [&](const Aabb& box) {
        smallest = std::min(smallest, box.max.x() - box.min.x());
        largest = std::max(largest, box.max.x() - box.min.x());
    });
    EXPECT_LT(smallest, 1.1);
    EXPECT_GT(largest, 900);
}

TEST(MovingBoxes, MoveAsTold) {
    const auto frame = [](BoxMotion motion) { return moving_boxes({.motion = motion, .frame_count = 1}).frames[0]; };
    EXPECT_EQ(frame(BoxMotion::none).size(), 0u);
    EXPECT_EQ(frame(BoxMotion::tenth).size(), 100u);
    const MovingBoxes jumping = moving_boxes({.motion = BoxMotion::teleport, .count = 5000, .frame_count = 1});
    std::size_t jumps = 0;
    for (const BoxMove& move : jumping.frames[0]) {
        const double distance = (move.box.min - jumping.boxes[move.index].min).norm();
        if (distance > 0.011) ++jumps;
    }
    EXPECT_GT(jumps, 25u);
    EXPECT_LT(jumps, 80u);
}

TEST(MovingBoxes, AreTheSameOnEveryMachine) {
    std::uint64_t digest = 0xcbf29ce484222325;
    for (const BoxLayout layout : layouts) {
        for_each_box(moving_boxes({.layout = layout, .motion = BoxMotion::teleport}), [&](const Aabb& box) {
            for (const Vec3* corner : {&box.min, &box.max})
                for (int axis = 0; axis < 3; ++axis)
                    digest = (digest ^ std::bit_cast<std::uint64_t>((*corner)[axis])) * 0x100000001b3;
        });
    }
    EXPECT_EQ(digest, 166614140063027749u);
}

}  // namespace
}  // namespace ecods::scenes
