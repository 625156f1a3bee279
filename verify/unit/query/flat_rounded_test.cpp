// Flat convex bodies where they meet other questions: as cores of rounded bodies, and in contact patches.
//
// A triangle as a mesh and as a convex solid is the same set: the numbers are compared, and depths are the oracle's.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/contact.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "oracle/rounded.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

using scenes::Random;
using Convex = std::shared_ptr<const ConvexSolid>;

Vec3 lattice_point(Random& random) {
    return {static_cast<double>(random.below(5)) - 2, static_cast<double>(random.below(5)) - 2,
            static_cast<double>(random.below(5)) - 2};
}

// One to three points, all of which a triangle has as corners.
struct Small {
    std::vector<Vec3> points;

    explicit Small(Random& random) {
        const std::size_t count = 1 + random.below(3);
        for (std::size_t i = 0; i < count; ++i) points.push_back(lattice_point(random));
    }
    std::shared_ptr<const MeshShape> mesh() const {
        const auto last = static_cast<std::uint32_t>(points.size() - 1);
        return std::make_shared<const MeshShape>(Mesh::create(points, {{0, std::min(1u, last), last}}));
    }
    Convex convex() const { return std::make_shared<const ConvexSolid>(std::span<const Vec3>(points)); }
};

Convex other_solid(Random& random) {
    if (random.below(2) == 0) return std::make_shared<const ConvexSolid>(scenes::cube(1));
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 4 + random.below(3); ++i) points.push_back(lattice_point(random));
    return std::make_shared<const ConvexSolid>(std::span<const Vec3>(points));
}

void expect_consistent(const SignedDistance& found) {
    const Vec3 between = found.point_b - found.point_a - found.distance * found.direction;
    EXPECT_LE(between.cwiseAbs().maxCoeff(), 0x1p-46) << found.distance;
    EXPECT_NEAR(found.direction.norm(), 1, 0x1p-50);
}

// Returns minus the depth by the oracle, if the cores share a point.
std::optional<double> minus_depth(const Posed<Rounded>& a, const Posed<Rounded>& b) {
    if (distance(Posed<MeshShape>(a.what->core(), a.pose), Posed<MeshShape>(b.what->core(), b.pose)) > 0) return {};
    const mpq_class square = oracle::squared_depth(oracle::posed_points(a.what->core().mesh(), a.pose),
                                                   oracle::posed_points(b.what->core().mesh(), b.pose));
    return oracle::minus_depth(square, a.what->radius(), b.what->radius());
}

// A depth's points are those of the patch's first corner, in whichever form the cores are given.
void expect_patch_agrees(const Posed<Rounded>& a, const Posed<Rounded>& b) {
    const SignedDistance found = signed_distance(a, b);
    const ContactPatch patch = contact_patch(a, b);
    EXPECT_EQ(patch.distance, found.distance);
    EXPECT_EQ(patch.normal, found.direction);
    ASSERT_FALSE(patch.corners.empty());
    if (!minus_depth(a, b)) return;
    EXPECT_EQ(patch.corners[0].point_a, found.point_a);
    EXPECT_EQ(patch.corners[0].point_b, found.point_b);
}

Pose mirrored(Random& random) {
    Pose pose = at(lattice_point(random) * 0.5);
    if (random.below(3) == 0) pose.R.col(0) *= -1;
    return pose;
}

TEST(FlatCores, HaveTheNumbersOfTriangles) {
    Random random(41);
    int meeting = 0;
    for (int i = 0; i < 600; ++i) {
        const Small small(random);
        const Convex b = other_solid(random);
        const double r = std::array{0.0, 0.5, 3.0}[random.below(3)];
        const double s = std::array{0.25, 1.0}[random.below(2)];
        const Pose at_a = mirrored(random), at_b = mirrored(random);
        const Rounded x(small.mesh(), r), y(small.convex(), r), z(b, s);
        const SignedDistance found = signed_distance({y, at_a}, {z, at_b});
        ASSERT_EQ(signed_distance({x, at_a}, {z, at_b}).distance, found.distance) << i;
        ASSERT_EQ(signed_distance({z, at_b}, {x, at_a}).distance, found.distance) << i;
        ASSERT_EQ(minus_depth({y, at_a}, {z, at_b}).value_or(found.distance), found.distance) << i;
        expect_consistent(found);
        expect_patch_agrees({x, at_a}, {z, at_b});
        expect_patch_agrees({z, at_b}, {y, at_a});
        meeting += intersects({*small.convex(), at_a}, {*b, at_b});
        ASSERT_EQ(intersects({x, at_a}, {z, at_b}), intersects({y, at_a}, {z, at_b})) << i;
        ASSERT_FALSE(HasFailure()) << i;
    }
    EXPECT_GT(meeting, 80);
}

TEST(FlatCores, TwoOfThemHaveTheNumbersOfTriangles) {
    Random random(42);
    int meeting = 0;
    for (int i = 0; i < 1500; ++i) {
        const Small a(random), b(random);
        const Pose at_a = mirrored(random), at_b = mirrored(random);
        const Rounded x(a.mesh(), 0.5), y(a.convex(), 0.5), z(b.mesh(), 0.25), w(b.convex(), 0.25);
        const double expected = signed_distance({x, at_a}, {z, at_b}).distance;
        ASSERT_EQ(minus_depth({x, at_a}, {z, at_b}).value_or(expected), expected) << i;
        for (const SignedDistance& found :
             {signed_distance({y, at_a}, {w, at_b}), signed_distance({x, at_a}, {w, at_b}),
              signed_distance({y, at_a}, {z, at_b})}) {
            ASSERT_EQ(found.distance, expected) << i;
            expect_consistent(found);
        }
        expect_patch_agrees({x, at_a}, {w, at_b});
        expect_patch_agrees({y, at_a}, {z, at_b});
        meeting += intersects({*a.convex(), at_a}, {*b.convex(), at_b});
        ASSERT_FALSE(HasFailure()) << i;
    }
    EXPECT_GT(meeting, 50);
}

// Every corner of a patch has points of both bodies, parted by the signed distance along the normal.
TEST(FlatPatches, PartBySignedDistance) {
    Random random(43);
    std::array<int, 3> of_dimension{};
    for (int i = 0; i < 4000; ++i) {
        const Small small(random);
        const Convex a = small.convex(), b = random.below(2) == 0 ? Small(random).convex() : other_solid(random);
        const Pose at_b = at(lattice_point(random) * 0.5);
        const ContactPatch patch = contact_patch({*a, Pose()}, {*b, at_b});
        const SignedDistance found = signed_distance({*a, Pose()}, {*b, at_b});
        ASSERT_EQ(patch.distance, found.distance) << i;
        ASSERT_FALSE(patch.corners.empty()) << i;
        ASSERT_EQ(patch.normal, found.direction) << i;
        EXPECT_EQ(patch.corners[0].point_a, found.point_a) << i;
        EXPECT_EQ(patch.corners[0].point_b, found.point_b) << i;
        for (const PatchCorner& corner : patch.corners) {
            EXPECT_LE((corner.point_b - corner.point_a - corner.gap * patch.normal).cwiseAbs().maxCoeff(), 0x1p-46);
        }
        if (const auto deep = depth_points({*a, Pose()}, {*b, at_b})) {
            ++of_dimension[static_cast<std::size_t>(a->dimension())];
            EXPECT_EQ(deep->point_a, found.point_a) << i;
            const auto along = depth_along({*a, Pose()}, {*b, at_b}, deep->depth.direction);
            ASSERT_TRUE(along) << i;
            EXPECT_NEAR(along->length, deep->depth.depth, 0x1p-46) << i;
        }
        const PatchLimits tilted{.min_cos_squared = 0.5};
        EXPECT_FALSE(contact_patch({*a, Pose()}, {*b, at_b}, tilted).corners.empty()) << i;
    }
    for (const int count : of_dimension) EXPECT_GT(count, 50);
}

// The cores of balls and capsules are flat.
TEST(FlatPatches, BallsAndCapsulesOnABox) {
    const ConvexSolid box(scenes::cube(2));
    const HalfSpace ground(Vec3::UnitZ(), 2);
    const auto ball = sphere(1), lying = capsule({-1, 0, 0}, {1, 0, 0}, 0.5),
               standing = capsule({0, 0, 0}, {0, 0, 2}, 0.5);
    const auto count = [&](const std::shared_ptr<const Rounded>& body, double height) {
        const ContactPatch patch = contact_patch({*body, at(0, 0, height)}, {box, Pose()});
        const ContactPatch on_ground = contact_patch({*body, at(0, 0, height)}, {ground, Pose()});
        EXPECT_EQ(patch.normal, Vec3(0, 0, -1));
        EXPECT_EQ(patch.distance, height - 2 - body->radius());
        EXPECT_EQ(on_ground.distance, patch.distance);
        EXPECT_EQ(on_ground.corners.size(), patch.corners.size());
        for (const PatchCorner& corner : patch.corners) {
            EXPECT_EQ(corner.point_a[2], height - body->radius());
            EXPECT_EQ(corner.point_b[2], 2);
        }
        return patch.corners.size();
    };
    for (const double height : {1.75, 2.0, 2.5, 3.0, 4.0}) {
        EXPECT_EQ(count(ball, height), 1u) << height;
        EXPECT_EQ(count(lying, height), 2u) << height;
        if (height >= 2) {
            EXPECT_EQ(count(standing, height), 1u) << height;
        }
    }
    const MeshShape surface(scenes::cube(1));
    EXPECT_THROW((void)contact_patch({surface, Pose()}, {box, Pose()}), NotSupported);
}

TEST(FlatPatches, ASquareOnASquareInItsPlane) {
    const std::array<Vec3, 4> square{Vec3(0, 0, 0), {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    const ConvexSolid plate(square);
    const ContactPatch patch = contact_patch({plate, Pose()}, {plate, at(1, 1)});
    EXPECT_EQ(patch.distance, 0);
    ASSERT_EQ(patch.corners.size(), 4u);
    for (const PatchCorner& corner : patch.corners) {
        EXPECT_EQ(corner.point_a, corner.point_b);
        EXPECT_EQ(corner.gap, 0);
    }
    const ContactPatch above = contact_patch({plate, Pose()}, {plate, at(1, 1, 3)});
    EXPECT_EQ(above.distance, 3);
    EXPECT_EQ(above.corners.size(), 4u);
}

}  // namespace
}  // namespace ecods
