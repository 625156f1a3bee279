#include "scenes/room.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pose_digest.hpp"

namespace ecods::scenes {
namespace {

TEST(Room, KeepsTheCentresInsideAndTheRotationsRotations) {
    const RoomOptions options{.ship_count = 20, .frame_count = 400, .side = 5, .seed = 2};
    std::size_t reflections = 0;
    const Scene scene = room(options);
    ASSERT_EQ(scene.frames.size(), 400u);
    std::vector<Vec3> last, step(20, Vec3::Zero());
    for (const SceneBody& body : scene.bodies) last.push_back(body.pose.t);
    for (const Frame& frame : scene.frames) {
        for (const Move& move : frame.moves) {
            const Vec3 moved = move.pose.t - last[move.body_index];
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_LE(std::abs(move.pose.t[axis]), 2.5);
                EXPECT_LE(std::abs(moved[axis]), options.speed_max + 1e-12);
                if (moved[axis] * step[move.body_index][axis] < 0) ++reflections;
            }
            EXPECT_LT((move.pose.R * move.pose.R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-14);
            step[move.body_index] = moved;
            last[move.body_index] = move.pose.t;
        }
    }
    EXPECT_GT(reflections, 50u);
}

TEST(Room, MovesTheShareThatIsAskedFor) {
    const Scene scene = room({.ship_count = 32, .frame_count = 3, .moving_share = 0.25});
    EXPECT_EQ(scene.bodies.size(), 32u);
    for (const Frame& frame : scene.frames) EXPECT_EQ(frame.moves.size(), 8u);
    EXPECT_TRUE(room({.frame_count = 1, .moving_share = 0}).frames[0].moves.empty());
}

TEST(Room, OneMoreFrameLeavesTheOthersAsTheyWere) {
    const Scene shorter = room({.frame_count = 5}), longer = room({.frame_count = 6});
    for (std::size_t f = 0; f < 5; ++f)
        for (std::size_t i = 0; i < 32; ++i) EXPECT_EQ(shorter.frames[f].moves[i].pose, longer.frames[f].moves[i].pose);
}

TEST(Room, DensityIsKept) {
    EXPECT_EQ(calibrated_side_by_density(32), calibrated_side());
    EXPECT_EQ(calibrated_side_by_density(256), 2 * calibrated_side());
}

// The poses themselves, bit for bit: benchmarks of different machines run the same scene.
TEST(Room, IsTheSameOnEveryMachine) {
    EXPECT_EQ(pose_digest(room({.frame_count = 50, .seed = 3})), 0x8fc5d382ef35a3bfu);
}

}  // namespace
}  // namespace ecods::scenes
