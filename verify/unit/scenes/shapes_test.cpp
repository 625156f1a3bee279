#include "scenes/shapes.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "mesh_measures.hpp"

namespace ecods::scenes {
namespace {

using std::numbers::pi;

TEST(Shapes, CubeIsClosedAndHasItsVolume) {
    const auto mesh = cube(1.5);
    EXPECT_EQ(mesh->vertices().size(), 8u);
    EXPECT_EQ(mesh->triangles().size(), 12u);
    EXPECT_TRUE(is_closed(*mesh));
    EXPECT_EQ(volume_of(*mesh), 27);
}

TEST(Shapes, SphereIsClosedAndNearlyRound) {
    const auto mesh = sphere(24, 12);
    EXPECT_EQ(mesh->vertices().size(), 24u * 11 + 2);
    EXPECT_EQ(mesh->triangles().size(), 2u * 24 * 11);
    EXPECT_TRUE(is_closed(*mesh));
    EXPECT_NEAR(volume_of(*mesh), 4 * pi / 3, 0.15);
    for (const Vec3& v : mesh->vertices()) EXPECT_NEAR(v.norm(), 1, 1e-5);
}

TEST(Shapes, TorusIsClosedAndNearlyRound) {
    const auto mesh = torus(40, 20, 0.25);
    EXPECT_EQ(mesh->vertices().size(), 800u);
    EXPECT_EQ(mesh->triangles().size(), 1600u);
    EXPECT_TRUE(is_closed(*mesh));
    EXPECT_NEAR(volume_of(*mesh), 2 * pi * pi * 0.0625, 0.05);
}

TEST(Shapes, SmallestSizesAreClosed) {
    EXPECT_TRUE(is_closed(*sphere(3, 2)));
    EXPECT_TRUE(is_closed(*torus(3, 3, 0.5)));
    EXPECT_GT(volume_of(*sphere(3, 2)), 0);
    EXPECT_GT(volume_of(*torus(3, 3, 0.5)), 0);
}

}  // namespace
}  // namespace ecods::scenes
