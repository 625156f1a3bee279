// Pairs of close features: known answers, and what must not matter. The oracle judges them in distance_test.cpp, with
// every family and in every environment.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "judge/feature_truth.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/each_case.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

// A small cube over the top of a large one, beside both diagonals of it.
class CubeOnCube : public testing::Test {
  protected:
    std::vector<CloseFeatures> close_at(const Pose& pose, double d) {
        return close_features({floor_, Pose()}, {cube_, pose}, d, memory_);
    }

    MeshShape floor_{scenes::cube(8)}, cube_{scenes::cube(1)};
    QueryMemory memory_;
};

TEST_F(CubeOnCube, EachLowerVertexOverTheFaceOnce) {
    for (const double gap : {1.0, 0x1p-40, 0.0}) {
        SCOPED_TRACE(gap);
        const std::vector<CloseFeatures> close = close_at(at(4.5, 0, 9 + gap), gap);
        ASSERT_EQ(close.size(), 4u);
        std::vector<std::pair<double, double>> places;
        for (const CloseFeatures& c : close) {
            EXPECT_EQ(c.closest.kind, ClosestKind::vertex_face);
            EXPECT_EQ(c.closest.distance, gap);
            EXPECT_EQ(c.closest.a, (Feature{Feature::Kind::face, close[0].closest.a.triangle, 0}));
            EXPECT_EQ(c.closest.b.kind, Feature::Kind::vertex);
            EXPECT_EQ(c.closest.point_a, Vec3(c.closest.point_b[0], c.closest.point_b[1], 8));
            EXPECT_EQ(c.closest.point_b[2], 8 + gap);
            // At distance 0 it is the face's normal, which points out of the cube.
            EXPECT_EQ(c.direction, Vec3(0, 0, 1));
            places.emplace_back(c.closest.point_b[0], c.closest.point_b[1]);
        }
        std::ranges::sort(places);
        EXPECT_EQ(places, (std::vector<std::pair<double, double>>{{3.5, -1}, {3.5, 1}, {5.5, -1}, {5.5, 1}}));
    }
}

// Deep enough in it that nothing touches: sides cross the top, and the lower triangles are not near it.
TEST_F(CubeOnCube, TrianglesThatCrossAreTwoFacesWithoutDirection) {
    const std::vector<CloseFeatures> close = close_at(at(4.5, 0, 8), 0);
    const std::vector<TrianglePair> pairs = intersecting_triangles({floor_, Pose()}, {cube_, at(4.5, 0, 8)}, memory_);
    ASSERT_EQ(close.size(), pairs.size());
    ASSERT_EQ(pairs.size(), 8u);
    for (std::size_t i = 0; i < close.size(); ++i) {
        EXPECT_EQ(close[i].closest.kind, ClosestKind::intersecting);
        EXPECT_EQ(close[i].closest.distance, 0);
        EXPECT_EQ(close[i].closest.a, (Feature{Feature::Kind::face, pairs[i].a, 0}));
        EXPECT_EQ(close[i].closest.b, (Feature{Feature::Kind::face, pairs[i].b, 0}));
        EXPECT_EQ(close[i].closest.point_a, close[i].closest.point_b);
        EXPECT_FALSE(close[i].direction);
    }
}

// Two edges and eight triangles around them, four of each mesh: one pair of features, named by the least triangles.
TEST(CloseFeatures, TwoEdgesThatCross) {
    const auto roof = [](double height, double side, double down, bool is_along_x) {
        const auto p = [&](double u, double v, double z) { return is_along_x ? Vec3(u, v, z) : Vec3(v, u, z); };
        return Mesh::create({p(-side, -9, down), p(0, 9, down), p(side, -9, down), p(-side, 0, height),
                             p(side, 0, height), p(0, -9, down)},
                            {{0, 1, 2}, {1, 3, 4}, {4, 3, 5}});
    };
    QueryMemory memory;
    for (const double gap : {3.0, 0.0}) {
        const MeshShape a(roof(0, 8, -5, true)), b(roof(gap, 4, gap + 5, false));
        const std::vector<CloseFeatures> close = close_features({a, Pose()}, {b, Pose()}, gap, memory);
        ASSERT_EQ(close.size(), 1u);
        EXPECT_EQ(close[0].closest.kind, ClosestKind::edge_edge);
        EXPECT_EQ(close[0].closest.a, (Feature{Feature::Kind::edge, 1, 1}));
        EXPECT_EQ(close[0].closest.b, (Feature{Feature::Kind::edge, 1, 1}));
        EXPECT_EQ(close[0].closest.point_a, Vec3(0, 0, 0));
        EXPECT_EQ(close[0].closest.point_b, Vec3(0, 0, gap));
        // At distance 0 the product of the edges from corner 1 to corner 2: along x and along y.
        EXPECT_EQ(close[0].direction, Vec3(0, 0, 1));
        const std::vector<CloseFeatures> swapped = close_features({b, Pose()}, {a, Pose()}, gap, memory);
        ASSERT_EQ(swapped.size(), 1u);
        EXPECT_EQ(swapped[0].direction, Vec3(0, 0, -1));
    }
}

// The lowest corner of a fan over the top of a cube: four triangles have it.
TEST(CloseFeatures, OneVertexOfManyTriangles) {
    const MeshShape cube(scenes::cube(0.5));
    const MeshShape fan(
        Mesh::create({Vec3(0.125, 0.25, 0), Vec3(1, 0, 1), Vec3(0, 1, 1), Vec3(-1, 0, 1), Vec3(0, -1, 1)},
                     {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}));
    QueryMemory memory;
    const Posed<MeshShape> a{cube, Pose()}, b{fan, at(0, 0, 0.75)};
    EXPECT_EQ(close_triangles(a, b, 0.25, memory).size(), 4u);
    const std::vector<CloseFeatures> close = close_features(a, b, 0.25, memory);
    ASSERT_EQ(close.size(), 1u);
    EXPECT_EQ(close[0].closest.kind, ClosestKind::vertex_face);
    EXPECT_EQ(close[0].closest.b, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(close[0].closest.distance, 0.25);
    EXPECT_EQ(close[0].direction, Vec3(0, 0, 1));
    EXPECT_TRUE(close_features(a, b, std::nextafter(0.25, 0), memory).empty());
}

TEST(CloseFeatures, VerticesThatTouchHaveNoDirection) {
    const MeshShape cube(scenes::cube(1));
    QueryMemory memory;
    const std::vector<CloseFeatures> touching = close_features({cube, Pose()}, {cube, at(2, 2, 2)}, 0, memory);
    ASSERT_EQ(touching.size(), 1u);
    EXPECT_EQ(touching[0].closest.kind, ClosestKind::vertex_vertex);
    EXPECT_FALSE(touching[0].direction);
    // Along an edge: a vertex of each on the other's edge.
    const std::vector<CloseFeatures> along = close_features({cube, Pose()}, {cube, at(2, 2, 1)}, 0, memory);
    ASSERT_EQ(along.size(), 2u);
    for (const CloseFeatures& c : along) {
        EXPECT_EQ(c.closest.kind, ClosestKind::vertex_edge);
        EXPECT_FALSE(c.direction);
    }
    // A little apart there is one: 2, 3, 6 over 7.
    const std::vector<CloseFeatures> apart = close_features({cube, Pose()}, {cube, at(4, 5, 8)}, 7, memory);
    ASSERT_EQ(apart.size(), 1u);
    EXPECT_EQ(apart[0].closest.distance, 7);
    EXPECT_EQ(apart[0].direction, Vec3(2.0 / 7, 3.0 / 7, 6.0 / 7));
}

TEST(CloseFeatures, BadDistancesAreErrors) {
    const MeshShape cube(scenes::cube(1));
    QueryMemory memory;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {-1.0, -0x1p-1074, std::numeric_limits<double>::quiet_NaN(), -infinity, infinity}) {
        EXPECT_INVALID(close_features({cube, Pose()}, {cube, Pose()}, bad, memory), Argument::distance);
    }
    EXPECT_TRUE(close_features({cube, Pose()}, {cube, at(5, 0, 0)}, 2.5, memory).empty());
    EXPECT_TRUE(close_features({cube, Pose()}, {cube, at(3, 0, 0)}, -0.0, memory).empty());
    EXPECT_TRUE(intersections({cube, Pose()}, {cube, at(3, 0, 0)}, memory).empty());
}

std::vector<std::string> texts(const std::vector<CloseFeatures>& close) {
    std::vector<std::string> result;
    for (const CloseFeatures& c : close) result.push_back(judge::text(c));
    return result;
}

// Every corner with a vertex of its own, some with -0 for 0: which corners are one vertex is a matter of coordinates.
TEST(CloseFeatures, VerticesAreOnePerPlace) {
    const auto soup = [](const Mesh& mesh) {
        std::vector<Vec3> vertices;
        std::vector<Triangle> triangles;
        for (const Triangle& triangle : mesh.triangles()) {
            for (const std::uint32_t vertex : triangle) {
                Vec3 v = mesh.vertices()[vertex];
                for (int k = 0; k < 3; ++k) {
                    if (v[k] == 0 && vertices.size() % 2 == 1) v[k] = -v[k];
                }
                vertices.push_back(v);
            }
            const auto next = static_cast<std::uint32_t>(vertices.size());
            triangles.push_back({next - 3, next - 2, next - 1});
        }
        return Mesh::create(vertices, triangles);
    };
    const auto mesh = scenes::torus(8, 6, 0.5);  // has vertices on the axes
    const MeshShape whole(mesh), pieces(soup(*mesh));
    QueryMemory memory;
    std::size_t count = 0;
    for (const double x : {2.0, 2.25, 3.0, 3.0625}) {
        for (const double z : {0.0, 0.5, 1.0, 1.125}) {
            const auto expected = texts(close_features({whole, Pose()}, {whole, at(x, 0, z)}, 0.25, memory));
            EXPECT_EQ(texts(close_features({pieces, Pose()}, {whole, at(x, 0, z)}, 0.25, memory)), expected);
            EXPECT_EQ(texts(close_features({whole, Pose()}, {pieces, at(x, 0, z)}, 0.25, memory)), expected);
            EXPECT_EQ(texts(close_features({pieces, Pose()}, {pieces, at(x, 0, z)}, 0.25, memory)), expected);
            count += expected.size();
        }
    }
    EXPECT_GT(count, 100u);
}

// What is left of features without their names, in any order. Normals of touching edges depend on how these are named.
std::vector<std::string> places(const std::vector<CloseFeatures>& close, bool is_mirrored) {
    std::vector<std::string> result;
    for (CloseFeatures c : close) {
        c.closest.a = c.closest.b = {};
        if (c.closest.distance == 0) c.direction.reset();
        if (is_mirrored) {
            std::swap(c.closest.point_a, c.closest.point_b);
            if (c.direction) *c.direction = Vec3::Zero() - *c.direction;
        }
        result.push_back(judge::text(c));
    }
    std::ranges::sort(result);
    return result;
}

std::shared_ptr<const Mesh> turned(const Mesh& mesh) {
    std::vector<Triangle> triangles(mesh.triangles().rbegin(), mesh.triangles().rend());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        std::rotate(triangles[i].begin(), triangles[i].begin() + static_cast<std::ptrdiff_t>(i % 3),
                    triangles[i].end());
    }
    return Mesh::create({mesh.vertices().begin(), mesh.vertices().end()}, triangles);
}

double limit_for(double distance) {
    return std::min(distance * 1.25, std::numeric_limits<double>::max());
}

TEST(CloseFeatures, NoOrderOfTrianglesOrBodiesMatters) {
    QueryMemory memory;
    scenes::for_each_case(scenes::distance_families(), 11, 30, [&](const scenes::DistanceCase& made) {
        const MeshShape a(made.a), b(made.b), turned_a(turned(*made.a)), turned_b(turned(*made.b));
        const double d = limit_for(distance({a, made.pose_a}, {b, made.pose_b}, memory));
        const auto expected = places(close_features({a, made.pose_a}, {b, made.pose_b}, d, memory), false);
        ASSERT_FALSE(expected.empty());
        ASSERT_EQ(places(close_features({turned_a, made.pose_a}, {turned_b, made.pose_b}, d, memory), false), expected);
        ASSERT_EQ(places(close_features({b, made.pose_b}, {a, made.pose_a}, d, memory), true), expected);
    });
}

TEST(CloseFeatures, TheClosestAreAmongThem) {
    QueryMemory memory;
    int count = 0;
    scenes::for_each_case(scenes::distance_families(), 12, 30, [&](const scenes::DistanceCase& made) {
        const MeshShape a(made.a), b(made.b);
        const ClosestPoints c = closest({a, made.pose_a}, {b, made.pose_b}, memory);
        if (c.kind == ClosestKind::intersecting) return;
        const auto close = close_features({a, made.pose_a}, {b, made.pose_b}, limit_for(c.distance), memory);
        const auto is_closest = [&](const CloseFeatures& f) { return f.direction && judge::is_same(f.closest, c); };
        ASSERT_EQ(std::ranges::count_if(close, is_closest), 1);
        ++count;
    });
    EXPECT_GT(count, 200);
}

}  // namespace
}  // namespace ecods
