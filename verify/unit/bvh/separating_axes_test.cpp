// What shares a point is never separated, however hard it is tried; most of what is well apart is.

#include "bvh/separating_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/oracle.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/shapes.hpp"
#include "unit/bvh/separated_bodies.hpp"

namespace ecods::separating_axes_test {
namespace {

TEST(SeparatingAxes, NeverSeparateTrianglesThatMeet) {
    scenes::Random random(5);
    std::uint64_t separated = 0, apart = 0;
    for (const scenes::HardFamily family : scenes::hard_families()) {
        for (int i = 0; i < 300; ++i) {
            const scenes::PosedPair pair = scenes::make_pair(family, random);
            const auto mesh_of = [](const std::array<Vec3, 3>& t) {
                return Mesh::create({t.begin(), t.end()}, {{0, 1, 2}});
            };
            const Body a(mesh_of(pair.a), pair.pose_a), b(mesh_of(pair.b), pair.pose_b);
            const bool meet = triangle_triangle({pair.pose_a, pair.a}, {pair.pose_b, pair.b}) != Relation::disjoint;
            if (meet) {
                ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, 0, 0)) << scenes::name(family) << " " << i;
            } else {
                ++apart;
                separated += !let_through(a, b, 0, 0);
            }
        }
    }
    EXPECT_GT(separated, apart / 2) << "the test would be sound if it separated nothing";
}

// Boxes in contact under rotations that are off by more and more: rounding, shear, scale.
TEST(SeparatingAxes, NeverSeparateBoxesInContactUnderPerturbedMatrices) {
    scenes::Random random(11);
    for (const double error : {0.0, 1e-16, 1e-12, 1e-6, 1e-3, 0.3}) {
        for (int i = 0; i < 25; ++i) {
            const auto pose = [&] {
                Pose p;
                p.R = random.rotation().toRotationMatrix();
                for (int k = 0; k < 9; ++k) p.R.data()[k] += error * random.uniform(-1, 1);
                for (int k = 0; k < 3; ++k) p.t[k] = random.uniform(-10, 10);
                return p;
            };
            const Body a(scenes::cube(0.5), pose());
            Body b(scenes::cube(random.uniform(0.125, 1)), pose());
            bring_into_contact(a, b, Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1).normalized());
            const std::vector<TrianglePair> pairs = pairs_of(a, b);
            ASSERT_FALSE(pairs.empty());
            for (const TrianglePair& pair : pairs) {
                ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, pair.a, pair.b)) << error << " " << i;
            }
        }
    }
}

// The roots, in particular: boxes of which faces, edges or corners touch exactly.
TEST(SeparatingAxes, NeverSeparateRootsInExactContact) {
    const Body a(scenes::cube(0.5), Pose());
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                Pose pose;
                pose.t = Vec3(x, y, z);
                const Body b(scenes::cube(0.5), pose);
                for (const TrianglePair& pair : pairs_of(a, b)) {
                    ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, pair.a, pair.b));
                }
            }
        }
    }
}

// Far from the origin of their own coordinates, boxes are placed by sums that cancel: rounding is then larger than what
// boxes are rounded outwards by, and only the bound saves what touches. Contact is exact, whatever the common pose.
TEST(SeparatingAxes, NeverSeparateRootsInContactFarFromTheirOwnOrigins) {
    scenes::Random random(31);
    for (int exponent = 8; exponent <= 44; exponent += 4) {
        for (int i = 0; i < 40; ++i) {
            Pose pose;
            pose.R = random.rotation().toRotationMatrix();
            if (i % 4 == 3) pose.R += 0.3 * Mat3::NullaryExpr([&] { return random.uniform(-1, 1); });
            const auto cube_at = [](const Vec3& offset) {
                const auto cube = scenes::cube(0.5);
                std::vector<Vec3> vertices(cube->vertices().begin(), cube->vertices().end());
                for (Vec3& v : vertices) v += offset;
                return Mesh::create(std::move(vertices), {cube->triangles().begin(), cube->triangles().end()});
            };
            Vec3 place, step;
            for (int k = 0; k < 3; ++k) {
                place[k] = std::floor(random.uniform(-1, 1) * std::ldexp(1, exponent));
                pose.t[k] = random.uniform(-10, 10);
                step[k] = static_cast<double>(random.below(3)) - 1;
            }
            if (step.isZero()) step[2] = 1;
            const Body a(cube_at(place), pose), b(cube_at(place + step), pose);
            const std::vector<TrianglePair> pairs = pairs_of(a, b);
            ASSERT_FALSE(pairs.empty());
            for (const TrianglePair& pair : pairs) {
                ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, pair.a, pair.b)) << exponent << " " << i;
            }
        }
    }
}

// A flat box under a pose with two nearly parallel columns and a short third: the box's own normals, as computed, undo
// such a pose less precisely than their size tells, and a flat box has nothing to spare. A tiny triangle goes through
// the large one, near a corner.
TEST(SeparatingAxes, NeverSeparateFlatBoxesUnderShearedPoses) {
    scenes::Random random(37);
    constexpr double r = 1 - 0x1p-10, tiny = 0x1p-49;
    const auto flat = Mesh::create({Vec3(-r, -r, 0), Vec3(r, r, 0), Vec3(-r, r, 0)}, {{0, 1, 2}});
    for (int i = 0; i < 1000; ++i) {
        const Mat3 Q = random.rotation().toRotationMatrix();
        Pose sheared, there;
        const double angle = std::exp2(random.uniform(-12, -9)), length = std::exp2(random.uniform(-1, 1));
        sheared.R.col(0) = Q.col(0);
        sheared.R.col(1) = length * (Q.col(0) + angle * Q.col(1));
        sheared.R.col(2) = std::exp2(random.uniform(-3, 0)) * Q.col(2);
        there.t = sheared.R * (i % 2 == 0 ? Vec3(0.998, 0.9985, 0) : Vec3(-0.9985, -0.998, 0));
        const auto through = Mesh::create({tiny * Q.col(2), -tiny * Q.col(2), tiny * Q.col(0)}, {{0, 1, 2}});
        ASSERT_TRUE(oracle::intersects({flat, sheared}, {through, there}));
        const Body a(flat, sheared), b(through, there);
        ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, 0, 0)) << i;
    }
}

// Each kind of axis separates something that no axis before it does.
TEST(SeparatingAxes, AllFifteenAxesSeparateSomething) {
    scenes::Random random(21);
    std::array<int, 15> counts{};
    const auto cube = scenes::cube(0.5);
    const MeshBvh tree = build(*cube);
    for (int i = 0; i < 20000; ++i) {
        const Mat3 a = random.rotation().toRotationMatrix(), b = random.rotation().toRotationMatrix();
        SeparatingAxes axes;
        const int axis =
            axes.bind({tree, a}, {tree, b}, Vec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)));
        if (axis >= 0) ++counts[static_cast<std::size_t>(axis)];
    }
    for (const int count : counts) EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace ecods::separating_axes_test
