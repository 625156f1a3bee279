#include "scenes/random.hpp"

#include <gtest/gtest.h>

namespace ecods::scenes {
namespace {

TEST(Random, RepeatsWithItsSeedOnly) {
    Random a(7), b(7), c(8);
    bool differs = false;
    for (int i = 0; i < 100; ++i) {
        const double x = a.uniform(-2, 3);
        EXPECT_EQ(x, b.uniform(-2, 3));
        differs |= x != c.uniform(-2, 3);
    }
    EXPECT_TRUE(differs);
}

TEST(Random, StaysInItsRanges) {
    Random random(1);
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 4000; ++i) {
        const double x = random.uniform(-2, 3);
        EXPECT_GE(x, -2);
        EXPECT_LE(x, 3);
        EXPECT_LT(random.below(5), 5u);
        EXPECT_EQ(random.below(1), 0u);
        const Vec3 direction = random.direction();
        EXPECT_NEAR(direction.norm(), 1, 1e-15);
        EXPECT_NEAR(random.rotation().norm(), 1, 1e-15);
        sum += direction;
    }
    EXPECT_LT(sum.norm() / 4000, 0.05);
}

// The first numbers of the generator, so that a scene of today is a scene of tomorrow.
TEST(Random, GivesTheNumbersThatItAlwaysGave) {
    Random random(3);
    EXPECT_EQ(random.uniform(0, 1), 0.55079790437594056);
    EXPECT_EQ(random.below(1000), 70u);
}

}  // namespace
}  // namespace ecods::scenes
