#include "scenes/moving_boxes.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "oracle/oracle.hpp"

namespace ecods::scenes {
namespace {

constexpr BoxLayout layouts[] = {BoxLayout::dense, BoxLayout::sparse, BoxLayout::pile, BoxLayout::decades};
constexpr BoxMotion further_motions[] = {BoxMotion::hundredth, BoxMotion::random,        BoxMotion::burst,
                                         BoxMotion::churn,     BoxMotion::churn_at_rest, BoxMotion::one_new};

template <class Check>
void for_each_box(const MovingBoxes& boxes, const Check& check) {
    for (const Aabb& box : boxes.boxes) check(box);
    for (const std::vector<BoxMove>& frame : boxes.frames)
        for (const BoxMove& move : frame) check(move.box);
}

void expect_floats(const MovingBoxes& boxes) {
    for_each_box(boxes, [&](const Aabb& box) {
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(static_cast<double>(static_cast<float>(box.min[axis])), box.min[axis]) << boxes.name;
            EXPECT_EQ(static_cast<double>(static_cast<float>(box.max[axis])), box.max[axis]) << boxes.name;
            EXPECT_LT(box.min[axis], box.max[axis]) << boxes.name;
        }
    });
}

TEST(MovingBoxes, AreTheSameInFloat) {
    for (const BoxLayout layout : layouts) {
        expect_floats(moving_boxes({.layout = layout, .motion = BoxMotion::teleport, .count = 3000}));
    }
    for (const BoxLayout layout : {BoxLayout::walls, BoxLayout::clusters}) {
        expect_floats(moving_boxes({.layout = layout, .motion = BoxMotion::all, .count = 3000, .speed = 0.5}));
    }
    for (const BoxMotion motion : {BoxMotion::turn, BoxMotion::fly}) {
        expect_floats(moving_boxes({.layout = BoxLayout::ball, .motion = motion, .count = 3000, .frame_count = 300}));
    }
    for (const BoxMotion motion : further_motions) expect_floats(moving_boxes({.motion = motion, .count = 3000}));
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

// How many boxes change in a frame, and how many of these are new.
struct Changes {
    std::size_t moved, came;
};
Changes changes(BoxMotion motion, std::size_t frame) {
    const MovingBoxes boxes = moving_boxes({.motion = motion, .count = 2000, .frame_count = 4});
    Changes changes{boxes.frames[frame].size(), 0};
    for (const BoxMove& move : boxes.frames[frame]) changes.came += move.is_new ? 1 : 0;
    return changes;
}

TEST(MovingBoxes, ComeAndGoAsTold) {
    EXPECT_EQ(changes(BoxMotion::hundredth, 0).moved, 20u);
    EXPECT_GT(changes(BoxMotion::random, 0).moved, 5u);
    EXPECT_LT(changes(BoxMotion::random, 0).moved, 50u);
    EXPECT_EQ(changes(BoxMotion::burst, 1).moved, 0u);
    EXPECT_EQ(changes(BoxMotion::burst, 2).moved, 2000u);
    EXPECT_EQ(changes(BoxMotion::one_new, 3).moved, 1u);
    EXPECT_EQ(changes(BoxMotion::one_new, 3).came, 1u);
    const Changes churn = changes(BoxMotion::churn, 0), at_rest = changes(BoxMotion::churn_at_rest, 0);
    EXPECT_EQ(churn.moved, 2000u);
    EXPECT_GT(churn.came, 50u);
    EXPECT_LT(churn.came, 200u);
    EXPECT_EQ(at_rest.moved, at_rest.came);
    EXPECT_GT(at_rest.came, 50u);
    EXPECT_LT(at_rest.came, 200u);
}

// The distance of two boxes of a swarm stays what it was, but for rounding; that of one and where it was does not.
TEST(MovingBoxes, SwarmsStayTogether) {
    for (const BoxMotion motion : {BoxMotion::turn, BoxMotion::fly}) {
        const MovingBoxes swarm =
            moving_boxes({.layout = BoxLayout::ball, .motion = motion, .count = 500, .frame_count = 100});
        const auto centre = [](const Aabb& box) -> Vec3 { return (box.min + box.max) / 2; };
        const std::vector<BoxMove>& last = swarm.frames.back();
        ASSERT_EQ(last.size(), 500u);
        double distance = 0;
        for (std::size_t i = 1; i < 500; ++i) {
            const double before = (centre(swarm.boxes[i]) - centre(swarm.boxes[0])).norm();
            EXPECT_NEAR((centre(last[i].box) - centre(last[0].box)).norm(), before, 0.01);
            distance += (centre(last[i].box) - centre(swarm.boxes[i])).norm() / 500;
        }
        EXPECT_GT(distance, 2);
    }
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
