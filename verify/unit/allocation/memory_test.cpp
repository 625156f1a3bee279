// What a world holds, in bytes that were allocated: it does not grow back unseen.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "allocation/failing_allocations.hpp"
#include "ecods/world.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::allocation::memory_test {
namespace {

TEST(HeldBytes, AreThoseThatWereNotFreed) {
    const HeldBytes held;
    EXPECT_EQ(held.count(), 0u);
    std::vector<double> list(1000);
    EXPECT_GE(held.count(), 8000u);
    EXPECT_LE(held.count(), 8064u);
    list = std::vector<double>();
    EXPECT_EQ(held.count(), 0u);
}

struct Bytes {
    double placed, at_rest;  // a body: after the first update, and at rest after all moved for some time
};

Vec3 random_point(scenes::Random& random, double side) {
    const double x = random.uniform(0, side), y = random.uniform(0, side), z = random.uniform(0, side);
    return {x, y, z};
}

// A cloud of cubes, of which one in seven has a pair.
Bytes bytes_of_world(std::size_t count, bool reserves) {
    const auto cube = scenes::cube(0.5);
    std::vector<BodyId> bodies(count);
    const double side = 3 * std::cbrt(static_cast<double>(count));
    scenes::Random random(1);
    const HeldBytes held;
    World world;
    if (reserves) world.reserve(count);
    for (BodyId& body : bodies) {
        body = world.create_body(cube, {.t = random_point(random, side)});
    }
    world.update();
    Bytes result{};
    result.placed = static_cast<double>(held.count()) / static_cast<double>(count);
    for (int frame = 0; frame < 20; ++frame) {
        for (const BodyId& body : bodies) {
            Pose pose = world.pose(body);
            pose.t[body.slot % 3] += body.slot % 2 == 0 ? 0x1p-7 : -0x1p-7;
            world.set_pose(body, pose);
        }
        world.update();
    }
    // One moves until the others have been at rest for long enough.
    for (int frame = 0; frame < 60; ++frame) {
        Pose pose = world.pose(bodies.front());
        pose.t[0] += 0x1p-7;
        world.set_pose(bodies.front(), pose);
        world.update();
    }
    result.at_rest = static_cast<double>(held.count()) / static_cast<double>(count);
    return result;
}

TEST(Memory, OfAWorldAtRest) {
    for (const std::size_t count : {10'000, 16'384, 30'000}) {
        for (const bool reserves : {false, true}) {
            const Bytes bytes = bytes_of_world(count, reserves);
            EXPECT_LE(bytes.placed, 450) << count << (reserves ? ", reserved" : "");
            EXPECT_LE(bytes.at_rest, 460) << count << (reserves ? ", reserved" : "");
            EXPECT_GE(bytes.placed, 300) << "so that the bound follows what is reached";
        }
    }
}

}  // namespace
}  // namespace ecods::allocation::memory_test
