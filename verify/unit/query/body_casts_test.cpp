// Casts of bodies of which one is inside the other at the start, or goes there.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "unit/query/bodies.hpp"

namespace ecods::body_casts_test {
namespace {

using namespace bodies;

const Vec3 motion(-3, 0, 0);

// A translation, as such and as one of two poses, each with a witness all along.
std::optional<FirstContact> cast_both_ways(const Posed<MeshShape>& a, const Vec3& way, const Posed<MeshShape>& b) {
    QueryMemory memory;
    PairWitness witness, of_moving;
    const auto expected = cast(a, way, b);
    Pose to = a.pose;
    to.t += way;
    for (int round = 0; round < 3; ++round) {
        EXPECT_EQ(cast(a, way, b, 1, {memory, witness}), expected);
        const Moving<MeshShape> moving(*a.what, a.pose, to), still(*b.what, b.pose, b.pose);
        EXPECT_EQ(cast(moving, still, 1, {memory, of_moving}), expected);
    }
    // Seen from the other body.
    const auto turned = cast(b, Vec3(-way), a);
    EXPECT_EQ(turned.has_value(), expected.has_value());
    if (turned && expected) {
        EXPECT_EQ(turned->time, expected->time);
    }
    return expected;
}

TEST(BodyCasts, ContainedAtTheStart) {
    const Feature first{Feature::Kind::vertex, 0, 0};
    for (const MeshForm room : {MeshForm::solid, MeshForm::convex}) {
        const ShapePtr outer = make(room, box({-2, -2, -2}, {2, 2, 2}));
        for (const MeshForm form : all_forms) {
            const ShapePtr inner = make(form, box({-1, -1, -1}, {1, 1, 1}));
            const auto contact = cast_both_ways({inner, Pose()}, motion, {outer, Pose()});
            EXPECT_EQ(contact, (FirstContact{0, ClosestKind::contained, first, no_feature}));
            EXPECT_EQ(cast({outer, Pose()}, motion, {inner, Pose()}),
                      (FirstContact{0, ClosestKind::contained, no_feature, first}));
            const auto touching = cast_both_ways({inner, at(1)}, motion, {outer, Pose()});
            ASSERT_TRUE(touching);
            EXPECT_EQ(touching->time, 0);
            EXPECT_EQ(touching->kind, ClosestKind::intersecting) << "from inside";
            const auto outside = cast_both_ways({inner, at(4.5)}, motion, {outer, Pose()});
            ASSERT_TRUE(outside);
            EXPECT_EQ(outside->time, 0.5);
            EXPECT_FALSE(cast_both_ways({inner, at(6.5)}, motion, {outer, Pose()}));
            EXPECT_EQ(cast({inner, at(4.5)}, motion, {outer, Pose()}, 0.5), outside);
            EXPECT_FALSE(cast({inner, at(4.5)}, motion, {outer, Pose()}, std::nextafter(0.5, 0)));
        }
        // Its surface is met where the inner box goes out.
        const ShapePtr surface = make(MeshForm::surface, box({-2, -2, -2}, {2, 2, 2}));
        const ShapePtr inner = make(room, box({-1, -1, -1}, {1, 1, 1}));
        EXPECT_EQ(cast_both_ways({inner, Pose()}, motion, {surface, Pose()})->time, 1.0 / 3);
    }
}

TEST(BodyCasts, InACavity) {
    Soup soup = soup_of_box({-9, -9, -9}, {9, 9, 9});
    soup.add_box({-3, -3, -3}, {3, 3, 3});
    const ShapePtr hall = solid_of(soup);
    for (const MeshForm form : all_forms) {
        const ShapePtr cube = make(form, box({-1, -1, -1}, {1, 1, 1}));
        const auto contact = cast_both_ways({cube, Pose()}, Vec3(0, 4, 0), {hall, Pose()});
        ASSERT_TRUE(contact);
        EXPECT_EQ(contact->time, 0.5);
        EXPECT_EQ(cast_both_ways({cube, at(5)}, Vec3(0, 4, 0), {hall, Pose()})->kind, ClosestKind::contained);
        EXPECT_FALSE(cast_both_ways({cube, Pose()}, Vec3(0, 1.5, 0), {hall, Pose()}));
    }
}

// Bodies that jump into each other between two poses meet on their way there, at the same time as their surfaces.
TEST(BodyCasts, IntoEachOther) {
    const auto mesh = box({-1, -1, -1}, {1, 1, 1});
    const ShapePtr outer = make(MeshForm::solid, box({-2, -2, -2}, {2, 2, 2}));
    const ShapePtr surface = make(MeshForm::surface, box({-2, -2, -2}, {2, 2, 2}));
    for (const MeshForm form : all_forms) {
        const ShapePtr inner = make(form, mesh);
        Pose turned = at(9, 0.25, 0.125);
        turned.R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        Pose mirrored = at(0.125);
        mirrored.R(0, 0) = -1;
        // Flat on its way, and mirrored at its end.
        const Moving<MeshShape> moving(*inner, turned, mirrored);
        const auto contact = cast(moving, Moving<MeshShape>(*outer, Pose(), Pose()));
        ASSERT_TRUE(contact);
        EXPECT_EQ(contact, cast(moving, Moving<MeshShape>(*surface, Pose(), Pose())));
        EXPECT_GT(contact->time, 0);
        const Moving<MeshShape> back(*inner, mirrored, turned);
        EXPECT_EQ(cast(back, Moving<MeshShape>(*outer, Pose(), Pose()))->time, 0);
        EXPECT_GT(cast(back, Moving<MeshShape>(*surface, Pose(), Pose()))->time, 0);
    }
}

TEST(BodyCasts, WhatIsRefusedIsRefusedInside) {
    const ShapePtr outer = make(MeshForm::solid, box({-2, -2, -2}, {2, 2, 2}));
    const ShapePtr inner = make(MeshForm::convex, box({-1, -1, -1}, {1, 1, 1}));
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    const Posed<MeshShape> a(inner, Pose()), b(outer, Pose());
    EXPECT_INVALID(cast(a, Vec3(0, nan, 0), b), Argument::motion);
    EXPECT_INVALID(cast(b, Vec3(0, 0, infinity), a), Argument::motion);
    EXPECT_INVALID(cast(a, motion, b, -1), Argument::time);
    EXPECT_INVALID(cast(a, motion, b, nan), Argument::time);
    EXPECT_INVALID(within(a, b, -1), Argument::distance);
    EXPECT_INVALID(within(a, b, nan), Argument::distance);
    EXPECT_INVALID(distance_bounds(a, b, {.relative = -1}), Argument::distance);
    EXPECT_INVALID(distance_bounds(a, b, {.absolute = nan}), Argument::distance);
}

}  // namespace
}  // namespace ecods::body_casts_test
