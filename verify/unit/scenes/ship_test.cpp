#include "scenes/ship.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh_measures.hpp"

namespace ecods::scenes {
namespace {

TEST(Ship, HasTheReportsCounts) {
    const auto mesh = ship();
    EXPECT_EQ(mesh->triangles().size(), 430u);
    EXPECT_EQ(mesh->vertices().size(), 300u);
}

TEST(Ship, UsesEveryVertexAndHasNoTriangleWithoutArea) {
    const auto mesh = ship();
    std::set<std::uint32_t> used;
    for (const Triangle& t : mesh->triangles()) {
        used.insert(t.begin(), t.end());
        const Vec3 ab = mesh->vertices()[t[1]] - mesh->vertices()[t[0]];
        const Vec3 ac = mesh->vertices()[t[2]] - mesh->vertices()[t[0]];
        EXPECT_GT(ab.squaredNorm() * ac.squaredNorm() - std::pow(ab.dot(ac), 2), 0);
    }
    EXPECT_EQ(used.size(), mesh->vertices().size());
}

TEST(Ship, IsTwoLongAndTwoWideWithinItsRadius) {
    Vec3 min = Vec3::Zero(), max = Vec3::Zero();
    double radius = 0;
    for (const Vec3& v : ship()->vertices()) {
        min = min.cwiseMin(v);
        max = max.cwiseMax(v);
        radius = std::max(radius, v.norm());
    }
    EXPECT_EQ(max.x() - min.x(), 2);
    EXPECT_EQ(max.y() - min.y(), 2);
    EXPECT_EQ(max.y(), -min.y());
    EXPECT_LE(radius, ship_radius());
    EXPECT_GE(radius, ship_radius() - 0.01);
}

TEST(Ship, IsOnTheGridAndTheSameEverywhere) {
    const auto mesh = ship();
    for (const Vec3& v : mesh->vertices())
        for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(std::ldexp(v[axis], 20), std::round(std::ldexp(v[axis], 20)));
    EXPECT_EQ(mesh->digest(), 0x68775952f86f06b7u);
    EXPECT_GT(volume_of(*mesh), 0.1);
}

}  // namespace
}  // namespace ecods::scenes
