// Contact patches whose corners one can count and compute by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "scenes/pose_at.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

ConvexSolid solid_box(const Vec3& half) {
    return ConvexSolid(box(-half, half));
}
const ConvexSolid& cube() {
    static const ConvexSolid solid = solid_box({0.5, 0.5, 0.5});
    return solid;
}

// Turns by a quarter, and by an eighth as exactly as a square of whole numbers may be.
Pose turned(const Pose& pose, const Mat3& R) {
    return {R * pose.R, pose.t};
}

std::vector<Vec3> points_of_a(const ContactPatch& patch) {
    std::vector<Vec3> points;
    for (const PatchCorner& corner : patch.corners) points.push_back(corner.point_a);
    return points;
}

// Expects that corners turn left around the normal, and what the definition says of all numbers of exact cases.
void expect_sound(const ContactPatch& patch) {
    const std::size_t count = patch.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const PatchCorner& c = patch.corners[i];
        EXPECT_EQ(c.point_b - c.point_a, c.gap * patch.normal);
        EXPECT_EQ(c.middle, 0.5 * (c.point_a + c.point_b));
        if (count < 3) continue;
        const Vec3 u = patch.corners[(i + 1) % count].point_a - c.point_a;
        const Vec3 v = patch.corners[(i + 2) % count].point_a - c.point_a;
        EXPECT_GT(u.cross(v).dot(patch.normal), 0) << i;
    }
}

// The corners of one are those of the other, from the other side.
void expect_mirrored(const ContactPatch& x, const ContactPatch& y) {
    EXPECT_EQ(x.distance, y.distance);
    EXPECT_EQ(x.normal, -y.normal);
    ASSERT_EQ(x.corners.size(), y.corners.size());
    const auto turned = [](PatchCorner c) {
        std::swap(c.a, c.b);
        std::swap(c.point_a, c.point_b);
        return c;
    };
    const auto begin = std::ranges::find(y.corners, turned(x.corners[0]));
    ASSERT_NE(begin, y.corners.end());
    const auto from = static_cast<std::size_t>(begin - y.corners.begin()), count = y.corners.size();
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(turned(x.corners[i]), y.corners[(from + count - i) % count]);
}

ContactPatch checked(const Posed<Shape>& a, const Posed<Shape>& b) {
    const ContactPatch patch = contact_patch(a, b);
    expect_sound(patch);
    expect_mirrored(patch, contact_patch(b, a));
    EXPECT_EQ(patch.corner_count, patch.corners.size());
    return patch;
}

TEST(ContactPatch, OfCubesAtLatticeOffsets) {
    for (const double z : {0.75, 1.0, 1.5}) {
        SCOPED_TRACE(z);
        for (const Vec3& t : {Vec3(0, 0, z), Vec3(0.25, 0.5, z), Vec3(0, 0.5, z)}) {
            const ContactPatch patch = checked({cube(), Pose()}, {cube(), at(t)});
            EXPECT_EQ(patch.distance, z - 1);
            EXPECT_EQ(patch.normal, Vec3(0, 0, 1));
            ASSERT_EQ(patch.corners.size(), 4U);
            double area = 0;
            const auto p = points_of_a(patch);
            for (std::size_t i = 1; i < 3; ++i) area += (p[i] - p[0]).cross(p[i + 1] - p[0]).z() / 2;
            EXPECT_EQ(area, (1 - t.x()) * (1 - t.y()));
        }
    }
    // on edges, and on corners
    EXPECT_EQ(checked({cube(), Pose()}, {cube(), at(1, 0, 1)}).corners.size(), 2U);
    EXPECT_EQ(checked({cube(), Pose()}, {cube(), at(1, 0.5, 2)}).corners.size(), 2U);
    EXPECT_EQ(checked({cube(), Pose()}, {cube(), at(1, 1, 1)}).corners.size(), 1U);
    EXPECT_EQ(contact_patch({cube(), Pose()}, {cube(), at(2, 2, 2)}).corners.size(), 1U);
    // a small one on a large one, and deep in it
    const ConvexSolid table = solid_box({4, 4, 1});
    EXPECT_EQ(checked({table, Pose()}, {cube(), at(2, 1, 1.25)}).corners.size(), 4U);
    EXPECT_EQ(checked({table, Pose()}, {cube(), at(4, 4, 1.5)}).corners.size(), 4U);
}

// A square of 1.5 on a diamond of radius 1: an octagon, of crossings alone. Cut at corners: five and six.
TEST(ContactPatch, OfASquareOnADiamond) {
    const ConvexSolid square = solid_box({0.75, 0.75, 0.5});
    const ConvexSolid diamond(
        std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}});
    for (const double z : {0.375, 0.5, 2.0}) {
        const ContactPatch patch = checked({square, Pose()}, {diamond, at(0, 0, z)});
        ASSERT_EQ(patch.corners.size(), 8U);
        for (const PatchCorner& corner : patch.corners) {
            EXPECT_EQ(corner.a.kind, Feature::Kind::edge);
            EXPECT_EQ(corner.b.kind, Feature::Kind::edge);
            EXPECT_EQ(corner.point_a.head<2>().cwiseAbs().sum(), 1);
        }
    }
    EXPECT_EQ(checked({square, Pose()}, {diamond, at(0.5, 0.5, 1)}).corners.size(), 5U);
    EXPECT_EQ(checked({square, Pose()}, {diamond, at(0.25, 0, 1)}).corners.size(), 7U);
    EXPECT_EQ(checked({square, Pose()}, {diamond, at(0.5, 0.125, 1)}).corners.size(), 6U);
    EXPECT_EQ(checked({square, Pose()}, {diamond, at(1.5, 0, 1)}).corners.size(), 3U);
    EXPECT_EQ(checked({square, Pose()}, {diamond, at(1.75, 0, 1)}).corners.size(), 1U);
}

// Wedges whose edges are up and down: across each other, along each other, and a point on a face.
TEST(ContactPatch, OfEdgesAndVertices) {
    const ConvexSolid roof(
        std::vector<Vec3>{{-2, -1, -1}, {2, -1, -1}, {-2, 1, -1}, {2, 1, -1}, {-2, 0, 0}, {2, 0, 0}});
    const ConvexSolid keel(std::vector<Vec3>{{-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {-1, 0, 0}, {1, 0, 0}});
    const ConvexSolid pin(std::vector<Vec3>{{0, 0, 0}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2}});
    const ConvexSolid slab = solid_box({2, 2, 1});
    Mat3 quarter;
    quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    for (const double z : {-0.125, 0.0, 0.5}) {
        SCOPED_TRACE(z);
        const ContactPatch across = checked({roof, Pose()}, {keel, turned(at(1, 0, z), quarter)});
        ASSERT_EQ(across.corners.size(), 1U);
        EXPECT_EQ(across.corners[0].point_a, Vec3(1, 0, 0));
        EXPECT_EQ(across.corners[0].point_b, Vec3(1, 0, z));
        const ContactPatch along = checked({slab, at(0, 0, -1)}, {keel, at(1.5, 0, z)});
        ASSERT_EQ(along.corners.size(), 2U);
        EXPECT_EQ(along.distance, z);
        EXPECT_EQ(checked({slab, at(0, 0, -1)}, {pin, at(0.25, 0, z)}).corners.size(), 1U);
    }
    // parallel edges, apart and touching: several normals then part them, and the first body names the first
    EXPECT_EQ(checked({roof, Pose()}, {keel, at(0, 0, 0.5)}).corners.size(), 2U);
    EXPECT_EQ(contact_patch({roof, Pose()}, {keel, at(2, 0, 0)}).corners.size(), 2U);
    EXPECT_EQ(contact_patch({roof, Pose()}, {keel, at(3, 0, 0)}).corners.size(), 1U);
}

TEST(ContactPatch, BeginsWithThePointsOfTheSignedDistance) {
    const ConvexSolid table = solid_box({3, 2, 1});
    for (const Vec3& t : {Vec3(0.25, 0.5, 1.25), Vec3(2.75, 2, 1.5), Vec3(3, 2, 4), Vec3(1, 1, 1), Vec3(5, 5, 5)}) {
        for (const Posed<ConvexSolid>& a : {Posed<ConvexSolid>(table, Pose()), Posed<ConvexSolid>(cube(), at(-t))}) {
            const Posed<ConvexSolid> b(a.what == &table ? cube() : table, a.what == &table ? at(t) : Pose());
            PairWitness witness;
            const SignedDistance d = signed_distance(a, b);
            const ContactPatch patch = contact_patch(a, b, {}, witness);
            EXPECT_EQ(patch.distance, d.distance);
            EXPECT_EQ(patch.normal, d.direction);
            EXPECT_EQ(patch.corners[0].point_a, d.point_a);
            EXPECT_EQ(patch.corners[0].point_b, d.point_b);
            EXPECT_EQ(patch.corners[0].a, d.a);
            EXPECT_EQ(patch.corners[0].b, d.b);
            EXPECT_NE(witness.a, PairWitness::none);
            EXPECT_EQ(contact_patch(a, b, {}, witness), patch);
        }
    }
}

TEST(ContactPatch, OfRoundedCubes) {
    const auto core = std::make_shared<const ConvexSolid>(box({-1, -1, -1}, {1, 1, 1}));
    const auto soft = rounded(core, 0.25), softer = rounded(core, 0.5);
    for (const double z : {2.25, 2.5, 2.75, 3.5, 1.75, 2.0}) {
        SCOPED_TRACE(z);
        const ContactPatch patch = checked({*soft, Pose()}, {*softer, at(1, 0, z)});
        EXPECT_EQ(patch.distance, z - 2.75);
        ASSERT_EQ(patch.corners.size(), 4U);
        for (const PatchCorner& corner : patch.corners) {
            EXPECT_EQ(corner.gap, z - 2.75);
            EXPECT_EQ(corner.point_a.z(), 1.25);
            EXPECT_EQ(corner.point_b.z(), z - 1.5);
        }
    }
    const ContactPatch with_hard = checked({*core, Pose()}, {*soft, at(0, 0, 4)});
    EXPECT_EQ(with_hard.distance, 1.75);
    // vertex to vertex: 3, 4 and 0
    const ContactPatch corner = contact_patch({*soft, Pose()}, {*soft, at(5, 6, 2.5)});
    EXPECT_NEAR(corner.distance, std::sqrt(9 + 16 + 0.25) - 0.5, 1e-15);
    EXPECT_EQ(corner.corners.size(), 1U);
}

TEST(ContactPatch, OnTheGround) {
    const HalfSpace ground(Vec3(0, 0, 2), 0);
    for (const double z : {-1.0, 0.25, 0.5, 3.0}) {
        SCOPED_TRACE(z);
        const ContactPatch patch = checked({cube(), at(1, 2, z)}, {ground, Pose()});
        EXPECT_EQ(patch.distance, z - 0.5);
        EXPECT_EQ(patch.normal, Vec3(0, 0, -1));
        ASSERT_EQ(patch.corners.size(), 4U);
        for (const PatchCorner& corner : patch.corners) {
            EXPECT_EQ(corner.point_b, Vec3(corner.point_a.x(), corner.point_a.y(), 0));
            EXPECT_EQ(corner.b, (Feature{Feature::Kind::face, 0, 0}));
        }
        // a mirrored cube, upon a mirrored ground
        Pose mirrored = at(1, 2, z), upside_down;
        mirrored.R(0, 0) = -1;
        upside_down.R(1, 1) = -1;
        EXPECT_EQ(checked({cube(), mirrored}, {ground, upside_down}).corners.size(), 4U);
    }
    const auto soft = rounded(std::make_shared<const ConvexSolid>(box({-1, -1, -1}, {1, 1, 1})), 0.5);
    const ContactPatch patch = checked({*soft, at(0, 0, 1)}, {ground, Pose()});
    EXPECT_EQ(patch.distance, -0.5);
    EXPECT_EQ(patch.corners[0].point_a.z(), -0.5);
    EXPECT_EQ(patch.corners[0].middle.z(), -0.25);
    const HalfSpace wall(Vec3(3, 0, 4), 0);
    EXPECT_EQ(contact_patch({cube(), at(3, 0, 4)}, {wall, Pose()}).corners.size(), 2U);
    EXPECT_THROW(std::ignore = contact_patch({wall, Pose()}, {ground, Pose()}), NotSupported);
}

TEST(ContactPatch, OfAtMostSomeCorners) {
    const ConvexSolid square = solid_box({0.75, 0.75, 0.5});
    const ConvexSolid diamond(
        std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}});
    const Posed<Shape> a(square, Pose()), b(diamond, at(0, 0, 1));
    const ContactPatch all = contact_patch(a, b);
    for (std::uint32_t most = 1; most < 10; ++most) {
        const ContactPatch patch = contact_patch(a, b, {.max_corners = most});
        EXPECT_EQ(patch.corners.size(), std::min(most, 8U));
        EXPECT_EQ(patch.corner_count, 8U);
        EXPECT_EQ(patch.corners[0], all.corners[0]);
    }
    // Opposite, and every other one: of ties the first.
    const ContactPatch two = contact_patch(a, b, {.max_corners = 2});
    EXPECT_EQ(two.corners[1].point_a, -all.corners[0].point_a + Vec3(0, 0, 1));
    const ContactPatch four = contact_patch(a, b, {.max_corners = 4});
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(four.corners[i], all.corners[2 * i]);
    // On the ground, too.
    const HalfSpace ground(Vec3::UnitZ(), 0);
    const ContactPatch on_ground = contact_patch({cube(), at(0, 0, 1)}, {ground, Pose()}, {.max_corners = 3});
    EXPECT_EQ(on_ground.corners.size(), 3U);
    EXPECT_EQ(on_ground.corner_count, 4U);
    // All choices of three have equal areas; the first one is chosen, by places in the patch of the caller's order.
    const Posed<Shape> cube_on_it(cube(), at(0, 0, 1)), plane(ground, Pose());
    for (const auto& [first, second] : {std::pair{cube_on_it, plane}, std::pair{plane, cube_on_it}}) {
        const ContactPatch whole = contact_patch(first, second);
        const ContactPatch three = contact_patch(first, second, {.max_corners = 3});
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(three.corners[i], whole.corners[i]);
    }
}

TEST(ContactPatch, UpToAGap) {
    const auto with_gap = [&](double z, double max_gap) {
        return contact_patch({cube(), Pose()}, {cube(), at(0, 0, z)}, {.max_gap = max_gap}).corners.size();
    };
    EXPECT_EQ(with_gap(1.5, 0.5), 4U);
    EXPECT_EQ(with_gap(1.5, std::nextafter(0.5, 0)), 0U);
    EXPECT_EQ(with_gap(0.75, -0.25), 4U);
    EXPECT_EQ(with_gap(0.75, std::nextafter(-0.25, -1)), 0U);
    EXPECT_EQ(with_gap(1, 0), 4U);
    EXPECT_EQ(with_gap(1, -0x1p-1074), 0U);
    // The gap is the root of 2, between two doubles.
    const double root = std::sqrt(2.0), below = root * root > 2 ? std::nextafter(root, 0) : root;
    EXPECT_EQ(contact_patch({cube(), Pose()}, {cube(), at(2, 2, 0)}, {.max_gap = below}).corners.size(), 0U);
    EXPECT_EQ(
        contact_patch({cube(), Pose()}, {cube(), at(2, 2, 0)}, {.max_gap = std::nextafter(below, 2)}).corners.size(),
        2U);
}

// A cube that is tilted by a shear of 2^-20 about one axis, or two, has an edge or a vertex as its lowest feature.
TEST(ContactPatch, OfTiltedFaces) {
    const ConvexSolid table = solid_box({4, 4, 1});
    const HalfSpace ground(Vec3::UnitZ(), 1);
    for (const double y : {0.0, -0x1p-20}) {
        Pose tilted = at(0, 0, 1.5);
        tilted.R(2, 0) = 0x1p-20;
        tilted.R(2, 1) = y;
        const std::size_t exact = y == 0 ? 2 : 1;
        for (const bool is_ground : {false, true}) {
            const Posed<Shape> below = is_ground ? Posed<Shape>(ground, Pose()) : Posed<Shape>(table, Pose());
            EXPECT_EQ(contact_patch(below, {cube(), tilted}).corners.size(), exact);
            const ContactPatch patch = contact_patch(below, {cube(), tilted}, {.min_cos_squared = 0.9999});
            ASSERT_EQ(patch.corners.size(), 4U);
            expect_sound(patch);
            EXPECT_EQ(patch.distance, patch.corners[0].gap);
            EXPECT_EQ(patch.distance, y == 0 ? -0x1p-21 : -0x1p-20);
            std::vector<double> gaps;
            for (const PatchCorner& corner : patch.corners) gaps.push_back(corner.gap);
            std::ranges::sort(gaps);
            EXPECT_EQ(gaps, y == 0 ? (std::vector{-0x1p-21, -0x1p-21, 0x1p-21, 0x1p-21})
                                   : (std::vector{-0x1p-20, 0.0, 0.0, 0x1p-20}));
            const PatchLimits limits{.min_cos_squared = 0.9999, .max_gap = 0};
            EXPECT_EQ(contact_patch(below, {cube(), tilted}, limits).corners.size(), y == 0 ? 2U : 3U);
            // The tilt's tangent is 2^-20, or the root of twice its square.
            const double tangent = y == 0 ? 0x1p-40 : 0x1p-39;
            EXPECT_EQ(contact_patch(below, {cube(), tilted}, {.min_cos_squared = 1 - tangent}).corners.size(), 4U);
            EXPECT_EQ(contact_patch(below, {cube(), tilted}, {.min_cos_squared = 1 - tangent / 2}).corners.size(),
                      y == 0 ? 2U : 2U);
        }
    }
}

TEST(ContactPatch, RefusesWhatItCannotAnswer) {
    const MeshShape surface(box({-1, -1, -1}, {1, 1, 1}));
    EXPECT_THROW(std::ignore = contact_patch({surface, Pose()}, {cube(), Pose()}), NotSupported);
    EXPECT_THROW(std::ignore = contact_patch({cube(), Pose()}, {surface, Pose()}), NotSupported);
    Pose flat;
    flat.R(2, 2) = 0;
    const HalfSpace ground(Vec3::UnitZ(), 0);
    for (const Shape* other : {static_cast<const Shape*>(&cube()), static_cast<const Shape*>(&ground)}) {
        for (const int argument : {0, 1}) {
            try {
                std::ignore = argument == 0 ? contact_patch({cube(), flat}, {*other, Pose()})
                                            : contact_patch({*other, Pose()}, {cube(), flat});
                FAIL();
            } catch (const SingularPose& error) {
                EXPECT_EQ(error.argument, argument);
            }
        }
    }
    constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, std::nextafter(1.0, 2.0), infinity, nan, -nan}) {
        EXPECT_THROW(std::ignore = contact_patch({cube(), Pose()}, {cube(), Pose()}, {.min_cos_squared = bad}),
                     InvalidArgument);
    }
    for (const double bad : {-infinity, nan, -nan}) {
        EXPECT_THROW(std::ignore = contact_patch({cube(), Pose()}, {cube(), Pose()}, {.max_gap = bad}),
                     InvalidArgument);
    }
}

}  // namespace
}  // namespace ecods
