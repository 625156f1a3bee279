// Hits of segments and rays: small known answers in many poses. The oracle judges the rest in the tests of casts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

using Corners = std::array<Vec3, 3>;
using Kind = Feature::Kind;

MeshShape shape_of(const Corners& corners) {
    return MeshShape(Mesh::create({corners.begin(), corners.end()}, {{0, 1, 2}}));
}

const Corners half_square{Vec3(0, 0, 0), Vec3(8, 0, 0), Vec3(0, 8, 0)};

// Integer matrices: products with small integers are exact. The second mirrors, the third is a rotation times 3.
std::array<Mat3, 4> matrices() {
    std::array<Mat3, 4> result;
    result[0].setIdentity();
    result[1] << 0, -1, 0, -1, 0, 0, 0, 0, 1;
    result[2] << 1, 2, 2, 2, 1, -2, -2, 2, -1;
    result[3] << 3, 1, -2, 0, 5, 1, 7, -1, 2;
    return result;
}

struct Expected {
    double enter, leave;
    HitKind kind;
    Kind feature;
    std::uint32_t corner;
};

// The hit of a segment with a triangle, in poses that move both.
void expect_hit(const Corners& corners, const Segment& segment, const std::optional<Expected>& expected) {
    const MeshShape shape = shape_of(corners);
    QueryMemory memory;
    for (const Mat3& R : matrices()) {
        for (const double scale : {1.0, 0x1p-1040, 0x1p900}) {
            const Pose pose{R * scale, Vec3(5, -3, 7) * scale};
            const auto at = [&](const Vec3& v) -> Vec3 { return pose.R * v + pose.t; };
            const Segment posed{at(segment.a), at(segment.b)};
            const std::optional<Hit> hit = first_hit(posed, {shape, pose}, memory);
            ASSERT_EQ(hit.has_value(), expected.has_value());
            EXPECT_EQ(all_hits(posed, {shape, pose}, memory).size(), expected.has_value());
            if (!expected) continue;
            HitKind kind = expected->kind;
            if (R.determinant() < 0 && kind == HitKind::front) {
                kind = HitKind::back;
            } else if (R.determinant() < 0 && kind == HitKind::back) {
                kind = HitKind::front;
            }
            EXPECT_EQ(hit->kind, kind);
            EXPECT_EQ(hit->feature, (Feature{expected->feature, 0, expected->corner}));
            EXPECT_EQ(hit->parameter, expected->enter);
            EXPECT_EQ(hit->leave_parameter, expected->leave);
            const Vec3 d = segment.b - segment.a;
            EXPECT_EQ(hit->point, at(segment.a + expected->enter * d));
            EXPECT_EQ(hit->leave_point, at(segment.a + expected->leave * d));
            EXPECT_EQ(hit->rank, 0u);
        }
    }
}

TEST(Hits, InsideTheFaceFromEitherSide) {
    expect_hit(half_square, {{2, 2, 4}, {2, 2, -4}}, Expected{0.5, 0.5, HitKind::front, Kind::face, 0});
    expect_hit(half_square, {{2, 2, -4}, {2, 2, 4}}, Expected{0.5, 0.5, HitKind::back, Kind::face, 0});
    expect_hit(half_square, {{2, 2, 4}, {2, 2, 0}}, Expected{1, 1, HitKind::front, Kind::face, 0});
    expect_hit(half_square, {{2, 2, 0}, {2, 2, 5}}, Expected{0, 0, HitKind::back, Kind::face, 0});
    expect_hit(half_square, {{2, 2, 4}, {2, 2, 1}}, {});
    expect_hit(half_square, {{2, 2, -1}, {2, 2, -4}}, {});
    expect_hit(half_square, {{5, 5, 4}, {5, 5, -4}}, {});
}

TEST(Hits, OnEdgesAndVertices) {
    expect_hit(half_square, {{2, 0, 4}, {2, 0, -4}}, Expected{0.5, 0.5, HitKind::edge, Kind::edge, 0});
    expect_hit(half_square, {{4, 4, 4}, {4, 4, -4}}, Expected{0.5, 0.5, HitKind::edge, Kind::edge, 1});
    expect_hit(half_square, {{0, 2, 4}, {0, 2, -4}}, Expected{0.5, 0.5, HitKind::edge, Kind::edge, 2});
    expect_hit(half_square, {{0, 0, 4}, {0, 0, -4}}, Expected{0.5, 0.5, HitKind::vertex, Kind::vertex, 0});
    expect_hit(half_square, {{8, 0, 4}, {8, 0, -4}}, Expected{0.5, 0.5, HitKind::vertex, Kind::vertex, 1});
    expect_hit(half_square, {{-1, 9, 0}, {1, 7, 0}}, Expected{0.5, 1, HitKind::along, Kind::edge, 1});
    expect_hit(half_square, {{-1, 7, 0}, {1, 9, 0}}, Expected{0.5, 0.5, HitKind::vertex, Kind::vertex, 2});
}

TEST(Hits, AlongTheFaceAndItsEdges) {
    expect_hit(half_square, {{-8, 2, 0}, {8, 2, 0}}, Expected{0.5, 0.875, HitKind::along, Kind::face, 0});
    expect_hit(half_square, {{1, 2, 0}, {5, 2, 0}}, Expected{0, 1, HitKind::along, Kind::face, 0});
    expect_hit(half_square, {{-8, 0, 0}, {8, 0, 0}}, Expected{0.5, 1, HitKind::along, Kind::edge, 0});
    expect_hit(half_square, {{6, 0, 0}, {2, 0, 0}}, Expected{0, 1, HitKind::along, Kind::edge, 0});
    expect_hit(half_square, {{-8, 2, 0}, {0, 2, 0}}, Expected{1, 1, HitKind::edge, Kind::edge, 2});
    expect_hit(half_square, {{9, 0, 0}, {12, 0, 0}}, {});
    expect_hit(half_square, {{-8, 2, 1}, {8, 2, 1}}, {});
    expect_hit(half_square, {{-8, 9, 0}, {8, 9, 0}}, {});
}

TEST(Hits, OfASegmentOfLengthZero) {
    expect_hit(half_square, {{2, 2, 0}, {2, 2, 0}}, Expected{0, 0, HitKind::face, Kind::face, 0});
    expect_hit(half_square, {{4, 4, 0}, {4, 4, 0}}, Expected{0, 0, HitKind::edge, Kind::edge, 1});
    expect_hit(half_square, {{0, 8, 0}, {0, 8, 0}}, Expected{0, 0, HitKind::vertex, Kind::vertex, 2});
    expect_hit(half_square, {{5, 5, 0}, {5, 5, 0}}, {});
    expect_hit(half_square, {{2, 2, 1}, {2, 2, 1}}, {});
}

TEST(Hits, OfTrianglesWithoutArea) {
    const Corners flat{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(8, 0, 0)};
    expect_hit(flat, {{1, 0, 4}, {1, 0, -4}}, Expected{0.5, 0.5, HitKind::edge, Kind::edge, 0});
    expect_hit(flat, {{2, 0, 4}, {2, 0, -4}}, Expected{0.5, 0.5, HitKind::vertex, Kind::vertex, 1});
    expect_hit(flat, {{4, 0, 4}, {4, 0, -4}}, Expected{0.5, 0.5, HitKind::edge, Kind::edge, 1});
    expect_hit(flat, {{-8, 0, 0}, {8, 0, 0}}, Expected{0.5, 1, HitKind::along, Kind::edge, 2});
    expect_hit(flat, {{-1, 0, 0}, {1, 0, 0}}, Expected{0.5, 1, HitKind::along, Kind::edge, 0});
    expect_hit(flat, {{1, 1, 4}, {1, 1, -4}}, {});
    expect_hit(flat, {{3, 0, 0}, {3, 0, 0}}, Expected{0, 0, HitKind::edge, Kind::edge, 1});
    const Corners point{Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)};
    expect_hit(point, {{1, 2, 4}, {1, 2, 2}}, Expected{0.5, 0.5, HitKind::vertex, Kind::vertex, 0});
    expect_hit(point, {{1, 2, 3}, {1, 2, 3}}, Expected{0, 0, HitKind::vertex, Kind::vertex, 0});
    expect_hit(point, {{1, 1, 4}, {1, 2, 2}}, {});
    const Corners two{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(8, 0, 0)};
    expect_hit(two, {{4, 0, 4}, {4, 0, -4}}, Expected{0.5, 0.5, HitKind::edge, Kind::edge, 1});
    expect_hit(two, {{0, 0, 4}, {0, 0, -4}}, Expected{0.5, 0.5, HitKind::vertex, Kind::vertex, 0});
}

TEST(Hits, RaysEndAtTheirLargestParameter) {
    const MeshShape shape = shape_of(half_square);
    const Posed<MeshShape> body{shape, {}};
    QueryMemory memory;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto hit = [&](const Ray& ray) { return first_hit(ray, body, memory); };
    EXPECT_EQ(hit({{2, 2, 3}, {0, 0, -1}, infinity})->parameter, 3);
    EXPECT_EQ(hit({{2, 2, 3}, {0, 0, -1}, 3})->parameter, 3);
    EXPECT_FALSE(hit({{2, 2, 3}, {0, 0, -1}, std::nextafter(3, 0)}));
    EXPECT_FALSE(hit({{2, 2, 3}, {0, 0, 1}, infinity}));
    // 1/3 lies above the double nearest to it.
    EXPECT_FALSE(hit({{2, 2, 1}, {0, 0, -3}, 1.0 / 3}));
    EXPECT_EQ(hit({{2, 2, 1}, {0, 0, -3}, std::nextafter(1.0 / 3, 1)})->parameter, 1.0 / 3);
    // Beyond the largest double, and below the least.
    EXPECT_EQ(hit({{2, 2, 1}, {0, 0, -0x1p-1074}, infinity})->parameter, infinity);
    EXPECT_FALSE(hit({{2, 2, 1}, {0, 0, -0x1p-1074}, std::numeric_limits<double>::max()}));
    EXPECT_EQ(hit({{2, 2, 0x1p-1074}, {0, 0, -0x1p1000}, infinity})->parameter, 0x1p-1074);
    EXPECT_FALSE(hit({{2, 2, 0x1p-1074}, {0, 0, -0x1p1000}, 0}));
    // A ray that ends where it begins is a point with a direction.
    EXPECT_EQ(hit({{2, 2, 0}, {0, 0, -1}, 0})->kind, HitKind::front);
    EXPECT_EQ(hit({{2, 2, 0}, {1, 0, 0}, 0})->kind, HitKind::face);
    const std::optional<Hit> along = hit({{2, 2, 0}, {1, 0, 0}, 0.1});
    EXPECT_EQ(along->kind, HitKind::along);
    EXPECT_EQ(along->leave_parameter, 0.1);
    EXPECT_EQ(along->leave_point, Vec3(2.1, 2, 0));
}

// So short that floats know neither its direction nor the planes that it is parallel to.
TEST(Hits, OfRaysTooShortForADirection) {
    const MeshShape shape(scenes::cube(0.5));
    QueryMemory memory;
    for (const double length : {0x1p-1074, 0x1p-300, 0x1p-60, 0x1p-20}) {
        for (const Vec3& direction : {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(1, 1, 1), Vec3(1, 0x1p-40, 0)}) {
            const Ray ray{Vec3::Constant(-0.5), direction, length};
            const std::vector<Hit> all = all_hits(ray, {shape, {}}, memory);
            const std::optional<Hit> first = first_hit(ray, {shape, {}}, memory);
            ASSERT_TRUE(first);
            EXPECT_EQ(first->kind, all[0].kind);
            EXPECT_EQ(first->feature, all[0].feature);
            EXPECT_EQ(first->leave_parameter, all[0].leave_parameter);
            std::size_t along = 0;
            for (const Hit& hit : all) along += hit.kind == HitKind::along;
            // Of two faces in z = -1/2, one or both have it; or all that have the edge.
            EXPECT_EQ(along > 0, direction[2] == 0) << length << ", " << direction.transpose();
        }
    }
}

// Fans of triangles around a vertex and along an edge, in every order of the triangles: the least is first, and named
// by its own corner, whether the line crosses its plane or lies in it.
TEST(Hits, TiesAtAVertexAndAlongAnEdge) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-4, 0, 0}, {0, -4, 0},
                                     {1, 1, 4}, {0, 0, 3}, {8, 0, 0}, {4, -1, 0}};
    // One that is longer than the edge it has with others, and one inside of which the line runs.
    std::vector<Triangle> triangles{{0, 1, 2}, {3, 0, 2}, {3, 4, 0}, {1, 0, 4}, {0, 5, 6},
                                    {5, 1, 0}, {0, 0, 1}, {0, 1, 7}, {0, 8, 2}};
    QueryMemory memory;
    std::sort(triangles.begin(), triangles.end());
    for (int order = 0; std::next_permutation(triangles.begin(), triangles.end()); ++order) {
        if (order % 503 != 0) continue;
        const MeshShape shape(Mesh::create(vertices, triangles));
        for (const Segment& segment :
             {Segment{{-1, -2, 5}, {1, 2, -5}}, Segment{{-1, -1, -4}, {1, 1, 4}}, Segment{{-8, 0, 0}, {8, 0, 0}},
              Segment{{1, 1, 4}, {-1, -1, -4}}, Segment{{0, 0, 0}, {8, 0, 0}}, Segment{{0, 0, 0}, {3, 0, 0}},
              Segment{{4, 0, 0}, {-2, 0, 0}}}) {
            const std::vector<Hit> all = all_hits(segment, {shape, {}}, memory);
            ASSERT_FALSE(all.empty());
            PairWitness witness{0, static_cast<std::uint32_t>(order % 10)};
            const std::optional<Hit> first = first_hit(segment, {shape, {}}, {memory, witness});
            ASSERT_TRUE(first);
            ASSERT_EQ(first->feature, all[0].feature) << order;
            ASSERT_EQ(first->kind, all[0].kind);
            ASSERT_EQ(first->leave_parameter, all[0].leave_parameter);
            ASSERT_EQ(first->leave_point, all[0].leave_point);
        }
    }
}

TEST(Hits, AreInTheOrderOfRealParametersAndNamed) {
    const auto mesh = scenes::cube(1);
    const MeshShape shape(mesh);
    const Posed<MeshShape> body{shape, {}};
    QueryMemory memory;
    const Segment diagonal{{-2, -2, -2}, {2, 2, 2}};
    const std::vector<Hit> all = all_hits(diagonal, body, memory);
    std::size_t through_vertex = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].kind == HitKind::vertex) ++through_vertex;
        EXPECT_EQ(all[i].rank, all[i].parameter == 0.25 ? 0u : 1u);
        if (i > 0 && all[i].rank == all[i - 1].rank) {
            EXPECT_LT(all[i - 1].triangle(), all[i].triangle());
        }
    }
    std::size_t at_corners = 0;
    for (const Triangle& triangle : mesh->triangles()) {
        for (const std::uint32_t corner : triangle) {
            const Vec3& v = mesh->vertices()[corner];
            if (v[0] == v[1] && v[1] == v[2]) ++at_corners;
        }
    }
    EXPECT_EQ(all.size(), at_corners);
    EXPECT_EQ(through_vertex, all.size());
    const std::optional<Hit> first = first_hit(diagonal, body, memory);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->feature, all[0].feature);
    EXPECT_EQ(first->point, Vec3(-1, -1, -1));
}

TEST(Hits, AWitnessIsTriedAndLeft) {
    const MeshShape shape(scenes::sphere(16, 8));
    const Posed<MeshShape> body{shape, {}};
    QueryMemory memory;
    const Segment segment{{0.1, 0.2, 3}, {0.11, 0.21, -3}};
    const std::optional<Hit> expected = first_hit(segment, body, memory);
    ASSERT_TRUE(expected);
    for (const std::uint32_t b : {PairWitness::none, 0u, 5u, 100000u, expected->triangle()}) {
        PairWitness witness{3, b};
        const std::optional<Hit> hit = first_hit(segment, body, {memory, witness});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->parameter, expected->parameter);
        EXPECT_EQ(hit->feature, expected->feature);
        EXPECT_EQ(witness.b, expected->triangle());
    }
}

TEST(Hits, RefuseWhatIsNotFinite) {
    const MeshShape shape(scenes::cube(1));
    QueryMemory memory;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_INVALID(first_hit(Segment{{0, 0, nan}, {1, 1, 1}}, {shape, {}}, memory), Argument::segment);
    EXPECT_INVALID(all_hits(Ray{{0, 0, 0}, {0, 0, 0}}, {shape, {}}, memory), Argument::ray);
    EXPECT_INVALID(all_hits(Ray{{0, 0, 0}, {0, 0, 1}, -1}, {shape, {}}, memory), Argument::ray);
    EXPECT_INVALID(first_hit(Ray{{0, 0, 0}, {0, 0, 1}, nan}, {shape, {}}, memory), Argument::ray);
}

}  // namespace
}  // namespace ecods
