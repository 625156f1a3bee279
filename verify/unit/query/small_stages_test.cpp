// Stages for bodies of special form: meshes of one triangle, and bodies that lie in one plane z = constant.
#include <gtest/gtest.h>

#include "ecods/intersection.hpp"
#include "oracle/oracle.hpp"
#include "scenes/each_case.hpp"
#include "scenes/flush_parts.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

std::shared_ptr<const Mesh> one_triangle(const std::array<Vec3, 3>& corners) {
    return Mesh::create({corners.begin(), corners.end()}, {{0, 1, 2}});
}

TEST(SingleTriangles, AnswerAsThePredicateOnEveryFamily) {
    scenes::Random random(12);
    QueryMemory memory;
    scenes::for_each_case(scenes::hard_families(), random, 300, [&](const scenes::PosedPair& pair) {
        const MeshShape a(one_triangle(pair.a)), b(one_triangle(pair.b));
        const Posed<MeshShape> x{a, pair.pose_a}, y{b, pair.pose_b};
        const Relation expected = triangle_triangle({pair.pose_a, pair.a}, {pair.pose_b, pair.b});
        ASSERT_EQ(relation(x, y, memory), expected);
        ASSERT_EQ(relation(y, x, memory), expected);
        ASSERT_EQ(intersects(x, y, memory), expected != Relation::apart);
        ASSERT_EQ(intersecting_triangles(x, y, memory).size(), expected != Relation::apart ? 1u : 0u);
    });
    EXPECT_EQ(memory.counts().queries, 4 * 300 * std::size(scenes::hard_families()));
}

TEST(SingleTriangles, NeedNoTreesWhereTheFilterDecides) {
    QueryMemory memory;
    const MeshShape a(scenes::one_triangle());
    Pose aside;
    aside.t = Vec3(0.1, 0.2, 0.5);
    PairWitness witness{7, 9};
    EXPECT_FALSE(intersects({a, Pose{}}, {a, aside}, {memory, witness}));
    EXPECT_EQ(witness.a, PairWitness::none);
    Pose across;
    across.R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    EXPECT_TRUE(intersects({a, Pose{}}, {a, across}, {memory, witness}));
    EXPECT_EQ(witness.a, 0u);
    EXPECT_EQ(memory.counts().box_tests, 0u);
    EXPECT_EQ(memory.counts().stages.semi_static_passes, 2u);
}

// All triangles of the 3 x 3 lattice, those of no area included.
std::shared_ptr<const Mesh> lattice_triangles(double z) {
    std::vector<Vec3> vertices;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) vertices.emplace_back(i, k, z);
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < 9; ++i)
        for (std::uint32_t j = i; j < 9; ++j)
            for (std::uint32_t k = j; k < 9; ++k)
                triangles.push_back((i + j) % 2 == 0 ? Triangle{i, j, k} : Triangle{i, k, j});
    return Mesh::create(std::move(vertices), std::move(triangles));
}

std::uint64_t expect_right(const MeshShape& a, const Pose& pose_a, const MeshShape& b, const Pose& pose_b) {
    QueryMemory memory;
    const oracle::OracleMesh exact_a(a.mesh_ptr(), pose_a), exact_b(b.mesh_ptr(), pose_b);
    const auto expected = oracle::intersecting_triangles(exact_a, exact_b);
    EXPECT_EQ(intersecting_triangles({a, pose_a}, {b, pose_b}, memory), expected);
    EXPECT_EQ(relation({a, pose_a}, {b, pose_b}, memory), expected.empty() ? Relation::apart : Relation::touching);
    const StageCounts& counts = memory.counts().stages;
    return counts.one_limb + counts.two_limbs + counts.many_limbs + counts.plane_passes;
}

// Coordinates with more digits than doubles have, in exact contact: the same map for both, which no filter knows.
TEST(FlatBodies, AllTrianglesOfALatticeInExactContact) {
    scenes::Random random(13);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double z : {0.0, 0.7}) {
            const MeshShape shape(scenes::across(*lattice_triangles(z), axis));
            Pose a;
            const double c = random.uniform(0.5, 0.9) + random.uniform(0, 0x1p-32),
                         s = random.uniform(0.1, 0.5) + random.uniform(0, 0x1p-32);
            const int x = (axis + 1) % 3, y = (axis + 2) % 3;
            a.R(x, x) = c, a.R(x, y) = -s, a.R(y, x) = s, a.R(y, y) = c;
            for (const double far : {0.0, 1.0, 2.0}) {
                Pose b = a;
                b.t = a.R.col(x) * far;
                if (far > 0) expect_right(shape, a, shape, b);
                b.t = a.R.col(y) * -far;
                if (far > 0) expect_right(shape, a, shape, b);
                // Neither the plane beside it nor the next double is the same plane.
                b.t[axis] = 0x1p-60;
                if (z == 0) expect_right(shape, a, shape, b);
                b.t[axis] = 0.5;
                expect_right(shape, a, shape, b);
                ASSERT_FALSE(testing::Test::HasFailure()) << axis << " " << z << " " << far;
            }
        }
    }
}

TEST(FlatBodies, NearAndFarWithoutIntegers) {
    const scenes::MeshPairs pairs = scenes::flat_polygons(60, 20, 3);
    const MeshShape shape(pairs.meshes[0].mesh);
    for (const scenes::MeshQuery& query : pairs.queries)
        EXPECT_EQ(expect_right(shape, query.a.pose, shape, query.b.pose), 0u);
}

// Flat is said of what is exactly flat: a number next to zero, in the mesh or the pose, is none.
TEST(FlatBodies, NearlyFatIsNotFlat) {
    const double least = 0x1p-1074;
    const auto bent = Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, least}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
    const auto flat = Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
    Pose a, b;
    a.R(0, 0) = 0.6, a.R(0, 1) = -0.8, a.R(1, 0) = 0.8, a.R(1, 1) = 0.6;
    b.R = a.R.transpose();
    b.t = Vec3(0.1, 0.2, 0);
    Pose tilted = b;
    tilted.R(2, 0) = least;
    for (const auto& [mesh, pose] : {std::pair{bent, b}, std::pair{flat, tilted}, std::pair{bent, tilted}}) {
        const MeshShape x(flat), y(mesh);
        QueryMemory memory;
        const oracle::OracleMesh exact_x(flat, a), exact_y(mesh, pose);
        EXPECT_EQ(intersecting_triangles({x, a}, {y, pose}, memory), oracle::intersecting_triangles(exact_x, exact_y));
        EXPECT_EQ(relation({x, a}, {y, pose}, memory), oracle::relation(exact_x, exact_y));
        EXPECT_EQ(relation({y, pose}, {x, a}, memory), oracle::relation(exact_y, exact_x));
    }
}

}  // namespace
}  // namespace ecods
