// What shares a point is never separated, however hard it is tried; most of what is well apart is.

#include "bvh/axes/separating_axes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "environment/each_environment.hpp"
#include "oracle/oracle.hpp"
#include "scenes/each_case.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/shapes.hpp"
#include "unit/bvh/separated_bodies.hpp"

namespace ecods::separating_axes_test {
namespace {

TEST(SeparatingAxes, NeverSeparateTrianglesThatMeet) {
    scenes::Random random(5);
    std::uint64_t separated = 0, apart = 0;
    scenes::for_each_case(scenes::hard_families(), random, 300, [&](const scenes::PosedPair& pair) {
        const Body a(scenes::one_triangle(pair.a), pair.pose_a), b(scenes::one_triangle(pair.b), pair.pose_b);
        const bool meet = triangle_triangle({pair.pose_a, pair.a}, {pair.pose_b, pair.b}) != Relation::apart;
        if (meet) {
            ASSERT_TRUE(let_through_in_every_rounding_mode(a, b, 0, 0));
        } else {
            ++apart;
            separated += !let_through(a, b, 0, 0);
        }
    });
    EXPECT_GT(separated, apart / 2) << "the test would be sound if it separated nothing";
}

// Boxes in contact under rotations that are off by more and more: rounding, shear, scale.
TEST(SeparatingAxes, NeverSeparateBoxesInContactUnderPerturbedMatrices) {
    scenes::Random random(11);
    for (const double error : {0.0, 1e-16, 1e-12, 1e-6, 1e-3, 0.3}) {
        for (int i = 0; i < 25; ++i) {
            const auto pose = [&] {
                Pose p = random.turned();
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
            Pose pose = random.turned();
            if (i % 4 == 3) pose.R += 0.3 * Mat3::NullaryExpr([&] { return random.uniform(-1, 1); });
            const auto cube_at = [](const Vec3& offset) {
                return scenes::mapped(*scenes::cube(0.5), [&](const Vec3& v) -> Vec3 { return v + offset; });
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

// Sheared boxes a little apart at a face: its normal separates them, which lies along no edge.
TEST(SeparatingAxes, FacesOfShearedBoxesSeparate) {
    scenes::Random random(37);
    const auto cube = scenes::cube(0.5);
    const MeshBvh tree = build(*cube);
    for (int i = 0; i < 100; ++i) {
        Mat3 R = random.rotation().toRotationMatrix();
        for (int k = 0; k < 9; ++k) R.data()[k] += 0.4 * random.uniform(-1, 1);
        if (std::abs(R.determinant()) < 0.1) continue;
        const int axis = i % 3;
        const Vec3 d = 1.001 * R.col(axis) + random.uniform(-0.5, 0.5) * R.col((axis + 1) % 3) +
                       random.uniform(-0.5, 0.5) * R.col((axis + 2) % 3);
        SeparatingAxes axes;
        EXPECT_EQ(axes.bind({tree, R}, {tree, R}, d), axis) << i;
    }
}

// What bind() answers, and of the sets that are ready then all that means something, bit by bit.
std::vector<std::uint32_t> bound(const PosedTree& a, const PosedTree& b, const Vec3& d, int first) {
    SeparatingAxes axes;
    std::vector<std::uint32_t> bits{static_cast<std::uint32_t>(axes.bind(a, b, d, first))};
    if (bits[0] != static_cast<std::uint32_t>(-1)) return bits;
    const auto put = [&](const auto& floats, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) bits.push_back(std::bit_cast<std::uint32_t>(floats[i]));
    };
    for (const AxisSet& set : axes.sets()) {
        for (const Projection* const p : {&set.a, &set.b}) {
            put(p->shift, 3);
            put(p->margin, 3);
            for (std::size_t j = 0; j < 3; ++j) {
                put(std::array{p->row[j][3]}, 1);
                if (p->is_unit) continue;
                put(p->p[j], 3);
                put(p->size[j], 3);
                put(p->row[j], 3);
            }
            bits.push_back(p->is_unit ? 1 : 0);
        }
        put(set.point_error, 3);
        bits.push_back(static_cast<std::uint32_t>(set.flat_axis));
        bits.push_back(set.is_bijective ? 1 : 0);
    }
    return bits;
}

// Whatever the registers are: turned boxes, which both sets are computed for at once in the widest; sheared and flat
// ones, and numbers beyond the limits, which they are not; and each axis asked for first.
TEST(SeparatingAxes, EveryInstructionSetBindsTheSame) {
    scenes::Random random(31);
    const auto flat =
        Mesh::create({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)}, {{0, 1, 2}, {1, 2, 3}});
    std::vector<MeshBvh> trees;
    for (const auto& mesh : {scenes::cube(0.5), scenes::torus(12, 8, 0.3), flat}) trees.push_back(build(*mesh));
    trees.push_back(trees.front());
    trees.back().root_center = {0.25f, -0.5f, 0.125f};  // beside the middle of its frame
    trees.back().root_half = {0.5f, 0.25f, 0.75f};
    int bound_count = 0, separated_count = 0;
    for (int i = 0; i < 600; ++i) {
        const MeshBvh &tree_a = trees[random.below(4)], &tree_b = trees[random.below(4)];
        Mat3 R[2];
        for (Mat3& r : R) {
            r = random.rotation().toRotationMatrix();
            if (i % 5 == 1) r = Mat3::Identity();
            if (i % 5 == 2) r.col(i % 3) *= 1 + std::ldexp(1, -static_cast<int>(random.below(50)));
            if (i % 11 == 3) r.col(i % 3).setZero();
            if (i % 13 == 4) r *= std::ldexp(1, static_cast<int>(random.below(1200)) - 600);
            if (i % 17 == 5) r = -r;
        }
        const double size = i % 7 == 6 ? 0x1p90 : i % 3 == 0 ? 0.5 : 2;
        const Vec3 d = size * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const int first = static_cast<int>(random.below(root_axis_count + 1)) - 1;
        const auto ask = [&] { return bound({tree_a, R[0]}, {tree_b, R[1]}, d, first); };
        std::map<std::string, std::vector<std::uint32_t>> by_mode;
        environment::in_each_environment(ask, [&](const std::vector<std::uint32_t>& bits, const std::string& where) {
            const std::string mode = where.substr(where.find(','));
            EXPECT_EQ(bits, by_mode.try_emplace(mode, bits).first->second) << i << " " << where;
            (bits.size() == 1 ? separated_count : bound_count) += 1;
        });
    }
    EXPECT_GT(bound_count, 1000);
    EXPECT_GT(separated_count, 1000);
}

}  // namespace
}  // namespace ecods::separating_axes_test
