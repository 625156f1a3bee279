// Where two bodies of a world meet, and which of their features are near each other.

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/slab_shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_contact_test {
namespace {

Posed<MeshShape> posed(const Shape& shape, const Pose& pose) {
    return {dynamic_cast<const MeshShape&>(shape), pose};
}

TEST(WorldContact, IsThatOfTheTwoBodiesInTheOrderGiven) {
    World world;
    QueryMemory memory;
    const BodyId a = world.create_body(scenes::cube(0.5), at(0));
    const BodyId b = world.create_body(scenes::cube(1), at(1.25, 0.125, 0.25));
    for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
        const auto shape_x = world.shape(x), shape_y = world.shape(y);
        const auto px = posed(*shape_x, world.pose(x)), py = posed(*shape_y, world.pose(y));
        const auto shared = world.intersections(x, y), expected = ecods::intersections(px, py, memory);
        ASSERT_EQ(shared.size(), expected.size());
        EXPECT_FALSE(shared.empty());
        for (std::size_t i = 0; i < shared.size(); ++i) {
            EXPECT_EQ(shared[i].triangles, expected[i].triangles);
            EXPECT_EQ(shared[i].shared.normal, expected[i].shared.normal);
        }
        const auto close = world.close_features(x, y, 0.25, memory);
        const auto expected_close = ecods::close_features(px, py, 0.25, memory);
        ASSERT_EQ(close.size(), expected_close.size());
        EXPECT_FALSE(close.empty());
        for (std::size_t i = 0; i < close.size(); ++i) {
            EXPECT_EQ(close[i].closest.a, expected_close[i].closest.a);
            EXPECT_EQ(close[i].closest.b, expected_close[i].closest.b);
            EXPECT_EQ(close[i].direction, expected_close[i].direction);
        }
    }
}

TEST(WorldContact, WhatIsNoPairOrNoDistanceIsRefused) {
    World world;
    world.set_test(slab_kind, ShapeKind::mesh(), std::make_shared<SlabTest>());
    const BodyId a = world.create_body(scenes::cube(0.5), at(0));
    const BodyId b = world.create_body(scenes::cube(0.5), at(2));
    const BodyId slab = world.create_body(std::make_shared<SlabShape>(), at(9));
    EXPECT_THROW(static_cast<void>(world.intersections(a, a)), SameBody);
    EXPECT_THROW(static_cast<void>(world.close_features(a, BodyId{}, 1)), StaleBody);
    for (const double bad : {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_INVALID(world.close_features(a, b, bad), Argument::distance);
    }
    try {
        std::ignore = world.close_features(a, slab, 1);
        ADD_FAILURE();
    } catch (const NotSupported& error) {
        EXPECT_EQ(error.question, Question::close_features);
        EXPECT_EQ(error.a, slab_kind);
    }
    try {
        std::ignore = world.intersections(slab, a);
        ADD_FAILURE();
    } catch (const NotSupported& error) {
        EXPECT_EQ(error.question, Question::intersections);
    }
    EXPECT_TRUE(world.intersections(a, b).empty());
    EXPECT_TRUE(world.close_features(a, b, 0.5).empty());
    EXPECT_FALSE(world.close_features(a, b, 1).empty());
}

}  // namespace
}  // namespace ecods::world_contact_test
