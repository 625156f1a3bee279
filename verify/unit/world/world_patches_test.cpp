// Contact patches that a World gives: of a pair, and of all colliding pairs of convex bodies.
#include <gtest/gtest.h>

#include <memory>
#include <tuple>

#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

TEST(WorldPatches, OfAStackOnTheGround) {
    World world;
    const auto cube = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    const auto ground = std::make_shared<const HalfSpace>(Vec3::UnitZ(), 0);
    const BodyId low = world.create_body(cube, at(0, 0, 0.5)), floor = world.create_body(ground, Pose());
    const BodyId high = world.create_body(rounded(cube, 0.25), at(0.5, 0, 1.75));
    const BodyId surface = world.create_body(scenes::cube(0.5), at(0.25, 0.25, 1.25));
    world.update();
    const auto patches = world.contact_patches();
    ASSERT_EQ(patches.size(), 2U);  // the surface has none, and the upper cube is off the ground
    EXPECT_EQ(patches[0].bodies, (BodyPair{low, floor}));
    EXPECT_EQ(patches[1].bodies, (BodyPair{low, high}));
    for (const BodyPatch& found : patches) {
        EXPECT_EQ(found.patch, world.contact_patch(found.bodies.a, found.bodies.b));
        EXPECT_EQ(found.patch.distance, 0);
        EXPECT_EQ(found.patch.corners.size(), 4U);
    }
    EXPECT_EQ(patches[0].patch.normal, Vec3(0, 0, -1));
    EXPECT_EQ(world.contact_patch(floor, low).normal, Vec3(0, 0, 1));
    EXPECT_EQ(world.contact_patches({.max_corners = 2})[1].patch.corners.size(), 2U);
    EXPECT_THROW(std::ignore = world.contact_patch(low, surface), NotSupported);
    EXPECT_THROW(std::ignore = world.contact_patches({.min_cos_squared = 2}), InvalidArgument);

    // Bodies that were moved are where they are now; those that were destroyed are left out.
    world.set_pose(low, at(0, 0, 0.25));
    EXPECT_EQ(world.contact_patches()[0].patch.distance, -0.25);
    world.destroy_body(high);
    EXPECT_EQ(world.contact_patches().size(), 1U);
    Pose flat;
    flat.R(2, 2) = 0;
    world.set_pose(low, flat);
    EXPECT_THROW(std::ignore = world.contact_patches(), SingularPose);
}

}  // namespace
}  // namespace ecods
