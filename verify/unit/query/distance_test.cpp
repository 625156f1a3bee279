// The questions of distance.hpp: known answers, every family against the oracle, and what must not matter.
#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void expect_right(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory, PairWitness& witness) {
    expect_right(judge::DistanceTruth(a, b), memory, witness);
}

TEST(Distance, EveryFamilyAsTheOracle) {
    expect_all_right(scenes::distance_families(), 1, 60);
}

TEST(Distance, ShipsInRandomPoses) {
    const MeshShape ship(scenes::ship());
    scenes::Random random(2);
    QueryMemory memory;
    PairWitness witness;
    for (int i = 0; i < 12; ++i) {
        Pose a = random.turned(), b = random.turned();
        b.t = random.direction() * random.uniform(0.2, 3);
        expect_right({ship, a}, {ship, b}, memory, witness);
    }
}

struct Cubes {
    MeshShape cube{scenes::cube(0.5)};
    QueryMemory memory;

    Posed<MeshShape> posed(const Pose& pose) const { return {cube, pose}; }
    ClosestPoints closest_at(const Pose& pose) { return closest(posed(Pose()), posed(pose), memory); }
};

TEST(Distance, CubesBesideEachOther) {
    Cubes cubes;
    const ClosestPoints corners = cubes.closest_at(at(3, 4, 7));  // 2, 3 and 6 apart
    EXPECT_EQ(corners.distance, 7);
    EXPECT_EQ(corners.kind, ClosestKind::vertex_vertex);
    EXPECT_EQ(corners.point_a, Vec3(0.5, 0.5, 0.5));
    EXPECT_EQ(corners.point_b, Vec3(2.5, 3.5, 6.5));
    EXPECT_EQ(corners.triangles(), (TrianglePair{corners.a.triangle, corners.b.triangle}));
    // Edge over edge; a vertex of the one is over the other's edge, and vertices come first.
    EXPECT_EQ(cubes.closest_at(at(4, 5, 0.25)).distance, 5);
    EXPECT_EQ(cubes.closest_at(at(4, 5, 0.25)).kind, ClosestKind::vertex_edge);
    EXPECT_EQ(cubes.closest_at(at(4, 5, 0)).kind, ClosestKind::vertex_vertex);
    EXPECT_EQ(cubes.closest_at(at(3, 0.25, 0.125)).distance, 2);
    EXPECT_EQ(cubes.closest_at(at(1, 0.25, 0.125)).kind, ClosestKind::intersecting);
    EXPECT_EQ(cubes.closest_at(at(1, 0.25, 0.125)).distance, 0);
}

// The name of a face is not that of the vertex of the same index: vertex 5 over face 7, and face 5 under vertex 7.
TEST(Distance, FacesAndVerticesOfOneIndexAreNotOne) {
    const auto far = [](int i) { return Vec3(1000 + 10 * i, 0, 0); };
    std::vector<Vec3> a, b;
    for (int i = 0; i < 18; ++i) a.push_back(far(i));
    for (int i = 0; i < 24; ++i) b.push_back(far(i) + Vec3(0, 0, 500));
    const auto face = [](std::vector<Vec3>& vertices, std::size_t triangle, double x) {
        vertices[3 * triangle] = Vec3(x - 8, -8, 0);
        vertices[3 * triangle + 1] = Vec3(x + 8, -8, 0);
        vertices[3 * triangle + 2] = Vec3(x, 8, 0);
    };
    const auto tip = [](std::vector<Vec3>& vertices, std::size_t vertex, double x, double height) {
        for (int i = 0; i < 3; ++i)
            vertices[vertex / 3 * 3 + static_cast<std::size_t>(i)] = Vec3(x, i, height < 0 ? -9 : 9);
        vertices[vertex] = Vec3(x, 0, height);
    };
    std::vector<Triangle> triangles_a(6), triangles_b(8);
    for (std::uint32_t i = 0; i < 6; ++i) triangles_a[i] = {3 * i, 3 * i + 1, 3 * i + 2};
    for (std::uint32_t i = 0; i < 8; ++i) triangles_b[i] = {3 * i, 3 * i + 1, 3 * i + 2};
    face(b, 7, 0);
    face(a, 5, 100);
    tip(b, 7, 100, 1);
    QueryMemory memory;
    for (int k = -4; k <= 4; ++k) {
        const double height = 1 + k * 0x1p-52;
        tip(a, 5, 0, height);
        const MeshShape first(Mesh::create(a, triangles_a)), second(Mesh::create(b, triangles_b));
        const ClosestPoints c = closest({first, Pose()}, {second, Pose()}, memory);
        EXPECT_EQ(c.distance, std::min(1.0, height)) << k;
        EXPECT_EQ(c.triangles(), k <= 0 ? (TrianglePair{1, 7}) : (TrianglePair{5, 2})) << k;
        EXPECT_EQ(distance({first, Pose()}, {second, Pose()}, memory), std::min(1.0, height)) << k;
    }
}

TEST(Distance, WithinIsDecidedForTheRealNumber) {
    Cubes cubes;
    const Pose there = at(2, 2, 2);  // the root of 3, which lies above 0x1.bb67ae8584caap0
    const auto is_within = [&](double d) { return within(cubes.posed(Pose()), cubes.posed(there), d, cubes.memory); };
    EXPECT_FALSE(is_within(0x1.bb67ae8584caap0));
    EXPECT_TRUE(is_within(0x1.bb67ae8584cabp0));
    EXPECT_FALSE(is_within(0));
    EXPECT_FALSE(is_within(-0.0));
    EXPECT_TRUE(is_within(infinity));
    EXPECT_EQ(distance(cubes.posed(Pose()), cubes.posed(there), cubes.memory), 0x1.bb67ae8584caap0);
}

TEST(Distance, TheSmallestAndTheLargest) {
    const MeshShape point(Mesh::create({Vec3::Zero()}, {{0, 0, 0}}));
    QueryMemory memory;
    const auto between = [&](const Vec3& at_a, const Vec3& at_b) {
        Pose a, b;
        a.t = at_a;
        b.t = at_b;
        return distance({point, a}, {point, b}, memory);
    };
    EXPECT_EQ(between(Vec3::Zero(), Vec3(0x1p-1074, 0, 0)), 0x1p-1074);
    EXPECT_EQ(between(Vec3::Zero(), Vec3::Zero()), 0);
    EXPECT_EQ(between(Vec3(-0x1p1023, 0, 0), Vec3(0x1p1023, 0, 0)), infinity);
    EXPECT_EQ(between(Vec3(0, -0x1p1022, 0), Vec3(0, 0x1p1022, 0)), 0x1p1023);
    // Smaller than any double, and yet apart.
    const MeshShape tiny(Mesh::create({Vec3(0x1p-600, 0, 0)}, {{0, 0, 0}}));
    Pose squeezed;
    squeezed.R *= 0x1p-600;
    EXPECT_EQ(distance({point, Pose()}, {tiny, squeezed}, memory), 0x1p-1074);
    EXPECT_FALSE(within({point, Pose()}, {tiny, squeezed}, 0, memory));
    EXPECT_TRUE(within({point, Pose()}, {tiny, squeezed}, 0x1p-1074, memory));
    const DistanceBounds beyond = distance_bounds({point, Pose()}, {tiny, squeezed}, {}, memory);
    EXPECT_EQ(beyond.lower, 0);
    EXPECT_EQ(beyond.upper, 0x1p-1074);
}

// Found by the fuzzer: two pairs of triangles whose distances round to one double, which lies between them. The
// interval was that double alone, from the pair that is farther.
TEST(Distance, BoundsOfPairsThatRoundToOneDouble) {
    scenes::Random random(9);
    QueryMemory memory;
    const MeshShape point(Mesh::create({Vec3::Zero()}, {{0, 0, 0}}));
    for (int i = 0; i < 300; ++i) {
        // Vertices, edges and faces about 1 away, to 2^-60 of that.
        std::vector<Vec3> vertices;
        std::vector<Triangle> triangles;
        for (std::uint32_t k = 0; k < 4; ++k) {
            const double x = random.uniform(-1, 0), y = random.uniform(0.5, 2), z = random.uniform(0.25, 1);
            const double height = static_cast<double>(random.below(5)) - 2;
            vertices.push_back(Vec3(x, -y, height));
            vertices.push_back(Vec3(random.below(2) == 0 ? x : z, y, height));
            vertices.push_back(Vec3(z, random.uniform(-1, 1), height));
            triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
        }
        const MeshShape faces(Mesh::create(vertices, triangles));
        Pose thin, above;
        thin.R(2, 2) = 0x1p-60;
        above.t[2] = 1;
        const judge::DistanceTruth truth({faces, thin}, {point, above});
        const DistanceBounds bounds = distance_bounds({faces, thin}, {point, above}, {}, memory);
        ASSERT_GE(oracle::compare(truth.exact(), bounds.lower), 0) << i;
        ASSERT_LE(oracle::compare(truth.exact(), bounds.upper), 0) << i;
    }
}

TEST(Distance, BadDistancesAreErrors) {
    Cubes cubes;
    const auto a = cubes.posed(Pose()), b = cubes.posed(at(3, 0, 0));
    PairWitness witness;
    for (const double bad : {-1.0, -0x1p-1074, nan, -infinity}) {
        EXPECT_INVALID(within(a, b, bad, cubes.memory), Argument::distance);
        EXPECT_INVALID(within(a, b, bad, {cubes.memory, witness}), Argument::distance);
        EXPECT_INVALID(close_triangles(a, b, bad, cubes.memory), Argument::distance);
        EXPECT_INVALID(distance_bounds(a, b, {.relative = bad}, cubes.memory), Argument::distance);
        EXPECT_INVALID(distance_bounds(a, b, {.absolute = bad}, cubes.memory), Argument::distance);
        EXPECT_INVALID(distance_bounds(a, b, {.max_distance = bad}, {cubes.memory, witness}), Argument::distance);
    }
    EXPECT_INVALID(close_triangles(a, b, infinity, cubes.memory), Argument::distance);
    EXPECT_EQ(distance(a, b, cubes.memory), 2);
}

TEST(Distance, KindsHaveNames) {
    std::ostringstream out;
    out << ClosestKind::vertex_vertex << " " << ClosestKind::intersecting;
    EXPECT_FALSE(out.str().empty());
    EXPECT_NE(out.str().find("intersecting"), std::string::npos);
}

// What a query leaves in its memory does not matter, and neither do instruction sets and rounding modes.
TEST(Distance, TheSameBitsInEveryEnvironment) {
    expect_all_right_everywhere(scenes::distance_families(), 3, 8);
}

// Triangles in another order, and their corners: the same number.
TEST(Distance, TheOrderOfTrianglesDoesNotMatter) {
    const auto mesh = scenes::torus(8, 6, 0.4);
    std::vector<Triangle> triangles(mesh->triangles().begin(), mesh->triangles().end());
    std::vector<Vec3> vertices(mesh->vertices().begin(), mesh->vertices().end());
    std::reverse(triangles.begin(), triangles.end());
    std::rotate(triangles.begin(), triangles.begin() + 31, triangles.end());
    for (Triangle& triangle : triangles) std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    const MeshShape plain(mesh), shuffled(Mesh::create(vertices, triangles));
    scenes::Random random(4);
    QueryMemory memory;
    for (int i = 0; i < 40; ++i) {
        Pose a = random.turned(), b;
        b.R = i % 2 == 0 ? a.R : Mat3(random.rotation().toRotationMatrix());
        b.t = random.direction() * random.uniform(1, 4);
        const double d = distance({plain, a}, {plain, b}, memory);
        EXPECT_EQ(distance({shuffled, a}, {plain, b}, memory), d);
        EXPECT_EQ(distance({shuffled, b}, {shuffled, a}, memory), d);
        EXPECT_EQ(closest({shuffled, a}, {plain, b}, memory).distance, d);
        EXPECT_EQ(d == 0, intersects({plain, a}, {plain, b}, memory));
        EXPECT_EQ(within({plain, a}, {shuffled, b}, 0, memory), d == 0);
    }
}

// A translation by v changes a distance by at most |v|: all numbers here are dyadic, and sums of roundings are left
// out.
TEST(Distance, TheTriangleInequalityUnderTranslation) {
    const MeshShape torus(scenes::torus(8, 6, 0.4)), ship(scenes::ship());
    scenes::Random random(5);
    QueryMemory memory;
    for (int i = 0; i < 60; ++i) {
        Pose a = random.turned(), b = random.turned();
        b.t = random.direction() * random.uniform(1, 4);
        Pose moved = b;
        const int axis = static_cast<int>(random.below(3));
        moved.t[axis] = std::ldexp(std::round(std::ldexp(b.t[axis], 20)), -20);
        b.t[axis] = moved.t[axis] + 0.125;
        const double before = distance({torus, a}, {ship, b}, memory);
        const double after = distance({torus, a}, {ship, moved}, memory);
        EXPECT_LE(std::abs(before - after), 0.125 + std::max(before, after) * 0x1p-52);
    }
}

// A body that moves: the witness of the last place is tried first, and changes nothing.
TEST(Distance, WitnessesOnAPath) {
    const MeshShape a(scenes::sphere(10, 8)), b(scenes::torus(10, 8, 0.3));
    QueryMemory memory;
    PairWitness witness;
    scenes::Random random(6);
    Pose pose_a, pose_b = random.turned();
    for (int i = 0; i < 200; ++i) {
        pose_b.t = Vec3(3.5 - i * 0.01, 0.1, 0.2);
        const double fresh = distance({a, pose_a}, {b, pose_b}, memory);
        ASSERT_EQ(distance({a, pose_a}, {b, pose_b}, {memory, witness}), fresh);
        PairWitness copy = witness;
        ASSERT_EQ(intersects({a, pose_a}, {b, pose_b}, {memory, copy}), fresh == 0);
        ASSERT_EQ(within({a, pose_a}, {b, pose_b}, fresh, {memory, witness}),
                  within({a, pose_a}, {b, pose_b}, fresh, memory));
        ASSERT_TRUE(judge::is_same(closest({a, pose_a}, {b, pose_b}, {memory, witness}),
                                   closest({a, pose_a}, {b, pose_b}, memory)));
    }
}

}  // namespace
}  // namespace ecods
