#include "ecods/intersection.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <thread>
#include <tuple>
#include <utility>

#include "ecods/error.hpp"
#include "oracle/oracle.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"
#include "unit/query/expect_intersection.hpp"

namespace ecods {
namespace {

Pose random_pose(scenes::Random& random, double reach) {
    Pose pose = random.turned();
    for (int k = 0; k < 3; ++k) pose.t[k] = random.uniform(-reach, reach);
    return pose;
}

TEST(TwoBody, RandomPosesOfShips) {
    const MeshShape ship(scenes::ship());
    scenes::Random random(2);
    QueryMemory memory;
    for (int i = 0; i < 60; ++i) {
        expect_right(ship, random_pose(random, 0.5), ship, random_pose(random, 0.5), memory);
    }
}

TEST(TwoBody, ScaledShearedMirroredAndSingularPoses) {
    const MeshShape sphere(scenes::sphere(12, 6)), torus(scenes::torus(12, 8, 0.25));
    scenes::Random random(4);
    QueryMemory memory;
    for (int i = 0; i < 150; ++i) {
        Pose a = random_pose(random, 0.5), b = random_pose(random, 0.5);
        switch (i % 5) {
            case 0:
                a.R *= 3;
                break;
            case 1:
                a.R(0, 1) += 2;
                break;
            case 2:
                a.R.col(0) *= -1;
                break;
            case 3:
                a.R.col(2).setZero();
                break;
            default:
                a.R.setZero();
                a.t = b.R * Vec3(1.25, 0, 0) + b.t;
                break;
        }
        expect_right(sphere, a, torus, b, memory);
        expect_right(torus, b, sphere, a, memory);
    }
}

TEST(TwoBody, FacesInContact) {
    const MeshShape cube(scenes::cube(0.5)), other(scenes::cube(0.25));
    QueryMemory memory;
    Pose a, b;
    for (const double x : {1.0, 0.75, 0.5, 0.0}) {
        for (const double y : {1.0, 0.75, 0.25, 0.0}) {
            b.t = Vec3(x, y, 0.25);
            expect_right(cube, a, cube, b, memory);
            expect_right(cube, a, other, b, memory);
            scenes::Random random(3);
            a.R = b.R = random.rotation().toRotationMatrix();
            expect_right(cube, a, other, b, memory);
            a.R = b.R = Mat3::Identity();
        }
    }
}

TEST(TwoBody, APointAndASegmentAreBodies) {
    const MeshShape cube(scenes::cube(0.5));
    const MeshShape point(Mesh::create({{0.5, 0.25, 0.125}}, {{0, 0, 0}}));
    const MeshShape segment(Mesh::create({{0.5, 0.25, 0.125}, {3, 2, 1}}, {{0, 1, 1}}));
    QueryMemory memory;
    const Pose pose;
    EXPECT_EQ(relation({cube, pose}, {point, pose}, memory), Relation::touching);
    EXPECT_EQ(relation({cube, pose}, {segment, pose}, memory), Relation::touching);
    EXPECT_EQ(relation({segment, pose}, {point, pose}, memory), Relation::touching);
    Pose moved;
    moved.t = Vec3(-0x1p-60, 0, 0);
    EXPECT_EQ(relation({cube, pose}, {point, moved}, memory), Relation::apart) << "just inside the surface";
    EXPECT_EQ(relation({cube, pose}, {segment, moved}, memory), Relation::crossing);
}

TEST(TwoBody, CountsAddUpAndRepeat) {
    const MeshShape ship(scenes::ship());
    scenes::Random random(9);
    const Pose a = random_pose(random, 0.25), b = random_pose(random, 0.25);
    QueryMemory first, second;
    std::ignore = intersecting_triangles({ship, a}, {ship, b}, first);
    std::ignore = intersecting_triangles({ship, a}, {ship, a}, second);
    second.reset_counts();
    std::ignore = intersecting_triangles({ship, a}, {ship, b}, second);
    const QueryCounts& x = first.counts();
    EXPECT_EQ(x.queries, 1u);
    std::uint64_t decided = 0;
    for (const Stage& stage : stages) decided += x.stages.*stage.count;
    EXPECT_EQ(x.stages.triangle_tests, decided);
    EXPECT_EQ(x.box_tests, second.counts().box_tests);
    EXPECT_EQ(x.stages, second.counts().stages);
    // Counts of counts: each once.
    QueryCounts sum = x;
    sum += x;
    EXPECT_EQ(sum.queries, 2u);
    EXPECT_EQ(sum.stages.triangle_tests, 2 * x.stages.triangle_tests);
    for (const Stage& stage : stages) EXPECT_EQ(sum.stages.*stage.count, 2 * (x.stages.*stage.count)) << stage.name;
}

// The tree is built by whichever thread comes first; each thread has a memory of its own.
TEST(TwoBody, ManyThreadsGetOneAnswer) {
    const MeshShape ship(scenes::ship());
    scenes::Random random(12);
    std::vector<Pose> poses;
    for (int i = 0; i < 40; ++i) poses.push_back(random_pose(random, 0.6));
    std::vector<std::vector<Relation>> answers(4);
    {
        std::vector<std::jthread> threads;
        for (auto& own : answers) {
            threads.emplace_back([&ship, &poses, &own] {
                QueryMemory memory;
                for (std::size_t i = 1; i < poses.size(); ++i) {
                    own.push_back(relation({ship, poses[0]}, {ship, poses[i]}, memory));
                }
            });
        }
    }
    for (const auto& own : answers) EXPECT_EQ(own, answers[0]);
}

// Whatever a witness holds, of other triangles, other bodies, or nonsense, the answer is that of a query without one.
TEST(TwoBody, NoWitnessChangesAnAnswer) {
    const MeshShape ship(scenes::ship()), torus(scenes::torus(12, 8, 0.25));
    scenes::Random random(31);
    QueryMemory memory;
    PairWitness kept;
    std::array<int, 2> counts{};
    for (int i = 0; i < 2000; ++i) {
        const Pose a = random_pose(random, 0.8), b = random_pose(random, 0.8);
        const Posed<MeshShape> x{ship, a}, y{torus, b};
        const bool expected = intersects(x, y, memory);
        ++counts[expected];
        ASSERT_EQ(intersects(x, y, {memory, kept}), expected);
        const auto number = [&] {
            return random.uniform(0, 3) < 1 ? PairWitness::none : static_cast<std::uint32_t>(random.uniform(0, 500));
        };
        PairWitness nonsense{number(), number()};
        ASSERT_EQ(intersects(x, y, {memory, nonsense}), expected);
        ASSERT_EQ(intersects(x, y, {memory, nonsense}), expected) << "with the witness that was just left";
    }
    EXPECT_GT(std::min(counts[0], counts[1]), 200);
}

TEST(TwoBody, AWitnessSavesWorkForBodiesThatMoveLittle) {
    const MeshShape ship(scenes::ship());
    scenes::Random random(32);
    std::array<QueryCounts, 2> counts;
    for (int i = 0; i < 100; ++i) {
        const Pose a = random_pose(random, 0.4);
        Pose b = random_pose(random, 0.4);
        QueryMemory without, with;
        PairWitness witness;
        for (int frame = 0; frame < 20; ++frame) {
            b.t += Vec3(0.001, 0.002, 0.001);
            std::ignore = intersects({ship, a}, {ship, b}, without);
            std::ignore = intersects({ship, a}, {ship, b}, {with, witness});
        }
        counts[0] += without.counts();
        counts[1] += with.counts();
    }
    EXPECT_EQ(counts[0].witness_hits, 0u);
    EXPECT_GT(counts[1].witness_hits, counts[1].queries / 3);
    EXPECT_LT(counts[1].box_tests, counts[0].box_tests / 2);
}

TEST(TwoBody, ARefittedShapeAnswersAsANewOne) {
    const MeshShape ship(scenes::ship());
    scenes::Random random(33);
    QueryMemory memory;
    auto soft = refit(ship, {ship.mesh().vertices().begin(), ship.mesh().vertices().end()});
    for (int i = 0; i < 20; ++i) {
        std::vector<Vec3> vertices(soft->mesh().vertices().begin(), soft->mesh().vertices().end());
        for (Vec3& v : vertices) v += 0.03 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        soft = refit(*soft, std::move(vertices));
        expect_right(*soft, random_pose(random, 0.3), ship, random_pose(random, 0.3), memory);
    }
    EXPECT_INVALID(refit(ship, {{0, 0, 0}}), InvalidMesh::Reason::index);
}

// What the exact layer knows of a mesh, digits and units above all, is that of the new vertices: contacts of a cube
// whose corners need all digits, refitted from one that needs few.
TEST(TwoBody, ARefittedShapeIsMeasuredAnew) {
    const MeshShape plain(scenes::cube(0.5));
    scenes::Random random(34);
    QueryMemory memory;
    for (int i = 0; i < 200; ++i) {
        std::vector<Vec3> vertices(plain.mesh().vertices().begin(), plain.mesh().vertices().end());
        const double far = std::ldexp(1, static_cast<int>(random.below(60)));
        for (Vec3& v : vertices) {
            for (double& x : v) x = x * far + random.uniform(-0x1p-20, 0x1p-20) * random.uniform(0, 0x1p-20);
        }
        const auto soft = refit(plain, vertices);
        // Its corners, edges and faces, and points an ulp beside them.
        Vec3 point = vertices[random.below(8)];
        if (i % 2 == 1) point = 0.5 * point + 0.5 * vertices[random.below(8)];
        if (i % 3 == 2) point[0] = std::nextafter(point[0], 0.0);
        const MeshShape needle(Mesh::create({point, 3 * point, point + Vec3(far, 0, 0)}, {{0, 1, 2}}));
        Pose a, b;
        a.t = b.t = Vec3(random.uniform(-1, 1), 0, 3);
        b.t[i % 3] += std::ldexp(random.uniform(-1, 1), -static_cast<int>(random.below(50)));
        expect_right(*soft, a, needle, a, memory);
        expect_right(*soft, a, needle, b, memory);
        expect_right(*soft, a, plain, b, memory);
    }
}

// The large body reaches beyond all doubles, the other is so flat that axes of the world are tried: with a mode that
// rounds down, a large number must not be taken for where the large body ends.
TEST(TwoBody, BodiesBeyondTheRangeOfDoublesTouchInEveryRoundingMode) {
    const auto large =
        Mesh::create({Vec3(-0x1p600, -0x1p600, 0), Vec3(0x1p600, -0x1p600, 0), Vec3(0, 0x1p600, 0)}, {{0, 1, 2}});
    const auto small = Mesh::create({Vec3(0, 0, -1), Vec3(1, 0, -1), Vec3(0, 0, 1)}, {{0, 1, 2}});
    Pose beyond, flat;
    beyond.R *= 0x1p600;
    flat.R(1, 1) = 0;
    flat.t = Vec3(0x1.fp1023, 0, 0);
    ASSERT_EQ(oracle::relation({large, beyond}, {small, flat}), Relation::crossing);
    const MeshShape a(large), b(small);
    QueryMemory memory;
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const Relation there = relation({a, beyond}, {b, flat}, memory);
        const Relation back = relation({b, flat}, {a, beyond}, memory);
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(there, Relation::crossing) << mode;
        EXPECT_EQ(back, Relation::crossing) << mode;
    }
}

// Found by the fuzzer: a body 2^60 times smaller at a corner of the other. Volumes of the two overflow in floats, and
// where a mode rounds down, in one direction only.
TEST(TwoBody, BodiesOfFarDifferentSizesTouchInEveryRoundingMode) {
    const auto mesh = Mesh::create({Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0.5, 0x1p-47)}, {{0, 1, 2}});
    Pose large, small;
    large.t = Vec3(0x1.ffffffffefd2fp+36, -0x1.5b3bc30666664p-4, -0x1.392c0ce56666ep+2);
    small.R << 0, 0, -0x1p-61, 0, -0x1p-60, 0, -0x1p-61, 0, 0;
    small.t = Vec3(0x1.ffffffffffd2fp+36, 0x1.a9310f3e66667p-2, -0x1.392c0ce566666p+2);
    ASSERT_TRUE(oracle::intersects({mesh, large}, {mesh, small}));
    const MeshShape shape(mesh);
    QueryMemory memory;
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const bool there = intersects({shape, large}, {shape, small}, memory);
        const bool back = intersects({shape, small}, {shape, large}, memory);
        std::fesetround(FE_TONEAREST);
        EXPECT_TRUE(there) << mode;
        EXPECT_TRUE(back) << mode;
    }
}

TEST(TwoBody, AMemoryThatWasMovedGoesOn) {
    const auto cube = scenes::cube(1);
    const MeshShape shape(cube);
    QueryMemory memory;
    Pose there;
    there.t = Vec3(2, 0, 0);
    EXPECT_TRUE(intersects({shape, Pose()}, {shape, there}, memory));
    QueryMemory moved = std::move(memory);
    EXPECT_EQ(moved.counts().queries, 1u);
    EXPECT_TRUE(intersects({shape, Pose()}, {shape, there}, moved));
    memory = std::move(moved);
    EXPECT_EQ(memory.counts().queries, 2u);
    there.t[0] = 2.5;
    EXPECT_FALSE(intersects({shape, Pose()}, {shape, there}, memory));
}

}  // namespace
}  // namespace ecods
