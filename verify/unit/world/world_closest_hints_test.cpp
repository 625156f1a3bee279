// The closest pairs of bodies that move, with the hints of the steps before: the answers of a memory without hints, to
// the last bit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/builders.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "scenes/random.hpp"

namespace ecods {
namespace {

using Convex = std::shared_ptr<const ConvexSolid>;

// An arm of links that swing among obstacles; some of them meet the arm at some steps.
class Swing {
  public:
    explicit Swing(std::uint32_t seed, double size) : random_(seed), size_(size) {
        for (int i = 0; i < 4; ++i) {
            const auto link = box(size * Vec3(0.1, 0.12, 0.3));
            links_.push_back(world.create_body({.shape = link, .pose = {}, .filter = {.groups = 1}}));
        }
        for (int i = 0; i < 9; ++i) {
            std::vector<Vec3> points;
            for (int k = 0; k < 10; ++k) points.push_back(0.2 * size * random_.direction());
            const Convex solid = std::make_shared<const ConvexSolid>(points);
            const Pose pose(random_.turned().R, random_.uniform(0.3, 1) * size * random_.direction());
            if (i == 8) {
                world.create_body({.shape = rounded(solid, 0.05 * size), .pose = pose, .filter = {.groups = 2}});
            } else {
                world.create_body({.shape = solid, .pose = pose, .filter = {.groups = 2}});
            }
        }
        go_to(0);
    }

    void go_to(int step) {
        const double s = 0.01 * step;
        Eigen::Isometry3d joint = Eigen::Isometry3d::Identity();
        std::vector<Pose> poses;
        for (std::size_t i = 0; i < links_.size(); ++i) {
            const auto of = static_cast<double>(i);
            const Vec3 axis = i % 2 == 0 ? Vec3::UnitZ() : Vec3::UnitY();
            joint = joint * Eigen::AngleAxisd(std::sin(s * (1 + 0.3 * of) + of), axis);
            poses.push_back(Pose::from_isometry(joint * Eigen::Translation3d(0, 0, 0.16 * size_)));
            joint = joint * Eigen::Translation3d(0, 0, 0.33 * size_);
        }
        world.set_poses(links_, poses);
    }

    World world;

  private:
    scenes::Random random_;
    double size_;
    std::vector<BodyId> links_;
};

TEST(WorldClosestHints, StepsAsWithoutHints) {
    Swing swing(3, 1);
    QueryMemory kept;
    int negative = 0, positive = 0;
    for (int step = 0; step < 400; ++step) {
        SCOPED_TRACE(step);
        swing.go_to(step % 7 == 0 ? 37 * step : step);  // sometimes a jump
        QueryMemory fresh;
        const auto expected = swing.world.closest_pair(World::no_limit, 1, 2, fresh);
        ASSERT_TRUE(expected);
        EXPECT_EQ(swing.world.closest_pair(World::no_limit, 1, 2, kept), expected);
        const auto all = swing.world.closest_pairs(World::no_limit, 1, 2);
        ASSERT_FALSE(all.empty());
        EXPECT_EQ(all.front(), *expected);
        // Limits at the distance and beside it.
        if (expected->distance > 0) {
            EXPECT_EQ(swing.world.closest_pair(std::nextafter(expected->distance, 2), 1, 2, kept), expected);
            EXPECT_EQ(swing.world.closest_pair(std::nextafter(expected->distance, 0), 1, 2, kept),
                      swing.world.closest_pair(std::nextafter(expected->distance, 0), 1, 2, fresh));
        }
        (expected->distance > 0 ? positive : negative) += 1;
        if (HasFailure()) return;
    }
    EXPECT_GT(positive, 20);
    EXPECT_GT(negative, 5);
}

// Two worlds have bodies of the same ids, so that each finds the other's hints.
TEST(WorldClosestHints, OfAnotherWorld) {
    Swing swing(3, 1), other(4, 64);
    QueryMemory shared;
    for (int step = 0; step < 100; ++step) {
        for (Swing* const each : {&swing, &other}) {
            each->go_to(3 * step);
            QueryMemory fresh;
            EXPECT_EQ(each->world.closest_pair(World::no_limit, 1, 2, shared),
                      each->world.closest_pair(World::no_limit, 1, 2, fresh))
                << step;
        }
    }
}

}  // namespace
}  // namespace ecods
