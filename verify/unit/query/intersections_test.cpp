// What triangles share: known answers in many poses. The oracle judges the rest in distance_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

using Corners = std::array<Vec3, 3>;

// Matrices of integers, some of which mirror: products with small integers are exact.
std::vector<Mat3> integer_matrices() {
    std::vector<Mat3> result(5);
    result[0].setIdentity();
    result[1] << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    result[2] << 1, 2, 2, 2, 1, -2, -2, 2, -1;  // a rotation times 3
    result[3] << 0, -1, 0, -1, 0, 0, 0, 0, 1;   // mirrors
    result[4] << 3, 1, -2, 0, 5, 1, 7, -1, 2;
    return result;
}

bool is_less(const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
}

MeshShape triangle(const Corners& corners) {
    return MeshShape(Mesh::create({corners.begin(), corners.end()}, {{0, 1, 2}}));
}

// Of corners that go around, in any pose: from the least on.
void expect_shared(const Corners& a, const Corners& b, const std::vector<Vec3>& corners, bool has_normal) {
    const MeshShape shape_a = triangle(a), shape_b = triangle(b);
    QueryMemory memory;
    for (const Mat3& R : integer_matrices()) {
        for (const double scale : {1.0, 0x1p-1060, 0x1p900}) {
            const Pose pose{R * scale, Vec3(5, -3, 7) * scale};
            std::vector<Vec3> expected;
            for (const Vec3& corner : corners) expected.emplace_back(pose.R * corner + pose.t);
            std::rotate(expected.begin(), std::ranges::min_element(expected, is_less), expected.end());
            const std::vector<TriangleIntersection> found = intersections({shape_a, pose}, {shape_b, pose}, memory);
            ASSERT_EQ(found.size(), 1u);
            EXPECT_EQ(found[0].triangles, (TrianglePair{0, 0}));
            ASSERT_EQ(found[0].shared.corner_count, expected.size());
            EXPECT_TRUE(std::ranges::equal(found[0].shared.corners(), expected));
            EXPECT_EQ(found[0].shared.normal.has_value(), has_normal);
        }
    }
}

const Corners half_square{Vec3(0, 0, 0), Vec3(8, 0, 0), Vec3(0, 8, 0)};

TEST(Intersections, PolygonsOfThreeToSixCorners) {
    expect_shared(half_square, {Vec3(1, 1, 0), Vec3(9, 1, 0), Vec3(1, 9, 0)}, {{1, 1, 0}, {7, 1, 0}, {1, 7, 0}}, true);
    expect_shared(half_square, {Vec3(-50, 2, 0), Vec3(58, 2, 0), Vec3(4, -106, 0)},
                  {{0, 0, 0}, {8, 0, 0}, {6, 2, 0}, {0, 2, 0}}, true);
    expect_shared(half_square, {Vec3(7, 2, 0), Vec3(7, -40, 0), Vec3(-60, 2, 0)},
                  {{0, 0, 0}, {7, 0, 0}, {7, 1, 0}, {6, 2, 0}, {0, 2, 0}}, true);
    const Corners upwards{Vec3(0, 0, 0), Vec3(6, 0, 0), Vec3(3, 6, 0)};
    const Corners downwards{Vec3(0, 4, 0), Vec3(6, 4, 0), Vec3(3, -2, 0)};
    const std::vector<Vec3> hexagon{{1, 2, 0}, {2, 0, 0}, {4, 0, 0}, {5, 2, 0}, {4, 4, 0}, {2, 4, 0}};
    expect_shared(upwards, downwards, hexagon, true);
    // Around the normal of the first triangle, whatever that of the second is.
    expect_shared(upwards, {downwards[1], downwards[0], downwards[2]}, hexagon, true);
    expect_shared(downwards, upwards, {hexagon.rbegin(), hexagon.rend()}, true);
    expect_shared({upwards[2], upwards[1], upwards[0]}, downwards, {hexagon.rbegin(), hexagon.rend()}, true);
}

TEST(Intersections, PointsAndSegments) {
    const Corners& floor = half_square;
    // An edge through the face; a vertex, an edge on it; edges that cross; faces that cross; a segment's inside.
    expect_shared(floor, {Vec3(1, 2, 0), Vec3(1, 2, 9), Vec3(2, 2, 9)}, {{1, 2, 0}}, true);
    expect_shared(floor, {Vec3(1, 2, 0), Vec3(1, -4, 0), Vec3(2, 2, 9)}, {{1, 0, 0}, {1, 2, 0}}, true);
    expect_shared(floor, {Vec3(4, -1, -1), Vec3(4, 1, 1), Vec3(4, -9, 9)}, {{4, 0, 0}}, true);
    expect_shared(floor, {Vec3(2, 2, -2), Vec3(2, 2, 2), Vec3(2, -6, 0)}, {{2, 0, 0}, {2, 2, 0}}, false);
    expect_shared(floor, {Vec3(8, 0, 0), Vec3(9, 2, 9), Vec3(9, 1, 9)}, {{8, 0, 0}}, false);
    expect_shared(floor, {Vec3(-3, 0, 0), Vec3(5, 0, 0), Vec3(2, -1, -3)}, {{0, 0, 0}, {5, 0, 0}}, false);
    expect_shared(floor, {Vec3(1, 2, -3), Vec3(1, 2, 3), Vec3(1, 2, 1)}, {{1, 2, 0}}, false);
    expect_shared(floor, {Vec3(1, 2, -3), Vec3(1, 2, 0), Vec3(1, 2, 3)}, {{1, 2, 0}}, false);  // a middle in the face
    expect_shared(floor, {Vec3(1, 2, 0), Vec3(1, 2, 0), Vec3(1, 2, 0)}, {{1, 2, 0}}, true);
    expect_shared(floor, {Vec3(1, 2, 0), Vec3(3, 2, 0), Vec3(2, 2, 0)}, {{1, 2, 0}, {3, 2, 0}}, true);
}

// Corners at thirds of an edge, and a face whose normal is -1, -2 and -2 over 3.
TEST(Intersections, NumbersAreRoundedOnce) {
    const MeshShape slope = triangle({Vec3(0, 0, 0), Vec3(6, -3, 0), Vec3(0, -3, 3)});
    const MeshShape tip = triangle({Vec3(2, -2, 1), Vec3(3, 0, 3), Vec3(3, 1, 3)});
    const MeshShape floor = triangle(half_square), through = triangle({Vec3(1, 1, -1), Vec3(2, 3, 2), Vec3(1, 1, 2)});
    QueryMemory memory;
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const std::vector<CloseFeatures> touching = close_features({slope, Pose()}, {tip, Pose()}, 0, memory);
        const std::vector<TriangleIntersection> on_face = intersections({tip, Pose()}, {slope, Pose()}, memory);
        const std::vector<TriangleIntersection> crossing = intersections({floor, Pose()}, {through, Pose()}, memory);
        std::fesetround(FE_TONEAREST);
        const Vec3 normal(-1.0 / 3, -2.0 / 3, -2.0 / 3);
        ASSERT_EQ(touching.size(), 1u);
        EXPECT_EQ(touching[0].closest.kind, ClosestKind::vertex_face);
        EXPECT_EQ(touching[0].direction, normal);
        ASSERT_EQ(on_face.size(), 1u);
        EXPECT_EQ(on_face[0].shared.normal, normal);
        ASSERT_EQ(crossing.size(), 1u);
        ASSERT_EQ(crossing[0].shared.corner_count, 2u);
        EXPECT_EQ(crossing[0].shared.corners()[0], Vec3(1, 1, 0));
        EXPECT_EQ(crossing[0].shared.corners()[1], Vec3(4.0 / 3, 5.0 / 3, 0));
    }
}

// Every pair of triangles of two cubes that share a region: as intersecting_triangles() has them.
TEST(Intersections, AreThoseOfAllIntersectingTriangles) {
    const MeshShape cube(scenes::cube(1));
    QueryMemory memory;
    for (const double x : {0.0, 0.5, 1.0, 2.0}) {
        for (const double y : {0.0, 0.25, 2.0}) {
            Pose pose;
            pose.t = Vec3(x, y, 0.5);
            const auto pairs = intersecting_triangles({cube, Pose()}, {cube, pose}, memory);
            const auto found = intersections({cube, Pose()}, {cube, pose}, memory);
            ASSERT_EQ(found.size(), pairs.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_EQ(found[i].triangles, pairs[i]);
                ASSERT_GE(found[i].shared.corner_count, 1u);
                ASSERT_LE(found[i].shared.corner_count, 6u);
                EXPECT_TRUE(std::ranges::all_of(found[i].shared.corners(), [&](const Vec3& corner) {
                    return !is_less(corner, found[i].shared.corners()[0]) && corner.cwiseAbs().maxCoeff() <= 1 &&
                           (corner - pose.t).cwiseAbs().maxCoeff() <= 1;
                }));
            }
        }
    }
}

}  // namespace
}  // namespace ecods
