// Pairs of triangles of two leaves: what is proven to cross does, what is proven apart is, and generic pairs are
// proven to be one or the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>

#include "scenes/each_case.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/shapes.hpp"
#include "unit/bvh/separated_bodies.hpp"

namespace ecods::triangle_pairs_test {
namespace {

struct Tally {
    int apart = 0, crossing = 0;                // pairs that are
    int proven_apart = 0, proven_crossing = 0;  // of these, known from the floats
    friend bool operator==(const Tally&, const Tally&) = default;
};

// Asks in every rounding mode, with every instruction set, of bodies whose trees are one leaf each. The roots may be
// apart: then nothing is asked.
void expect_sound(const Body& a, const Body& b, Tally& tally) {
    ASSERT_TRUE(a.tree.root.is_leaf() && b.tree.root.is_leaf());
    const TreeLeaf &x = a.tree.leaves[0], &y = b.tree.leaves[0];
    for (const int mode : rounding_modes) {
        std::fesetround(mode);
        SeparatingAxes axes;
        const int axis = axes.bind({a.tree, a.pose.R}, {b.tree, b.pose.R}, b.pose.t - a.pose.t);
        const TrianglePairs found = axis < 0 ? triangle_pairs(axes.sets(), x, y) : TrianglePairs{};
        for (const InstructionSet set : environment::supported_instruction_sets()) {
            const environment::InstructionSetLimit limit(set);
            const TrianglePairs same = axis < 0 ? triangle_pairs(axes.sets(), x, y) : TrianglePairs{};
            EXPECT_TRUE(same.near == found.near && same.crossing == found.crossing) << environment::name(set);
        }
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(found.crossing & ~found.near, 0u);
        for (std::size_t i = 0; i < x.count; ++i) {
            for (std::size_t j = 0; j < y.count; ++j) {
                const std::uint64_t bit = std::uint64_t{1} << (8 * j + i);
                const bool near = found.near & bit, crosses = found.crossing & bit;
                const Relation truth =
                    triangle_triangle(a.posed_triangle(x.triangle[i]), b.posed_triangle(y.triangle[j]));
                ASSERT_TRUE(!crosses || truth == Relation::crossing);
                ASSERT_TRUE(near || truth == Relation::apart);
                if (mode != FE_TONEAREST) continue;
                tally.apart += truth == Relation::apart;
                tally.crossing += truth == Relation::crossing;
                tally.proven_apart += !near;
                tally.proven_crossing += crosses;
            }
        }
    }
}

std::shared_ptr<const Mesh> soup(scenes::Random& random, std::size_t count, double size) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        for (int k = 0; k < 3; ++k) {
            vertices.push_back(at + size * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
        }
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

TEST(TrianglePairs, OfGenericTrianglesAreDecided) {
    scenes::Random random(3);
    Tally tally;
    for (int i = 0; i < 600; ++i) {
        const auto pose = [&] {
            Pose p;
            p.R = random.rotation().toRotationMatrix() * (i % 3 == 0 ? -1.0 : 1.0);
            for (int k = 0; k < 3; ++k) p.t[k] = random.uniform(-0.3, 0.3);
            return p;
        };
        expect_sound(Body(soup(random, 8, 1), pose()), Body(soup(random, 8, 1), pose()), tally);
    }
    EXPECT_GT(tally.crossing, 2000);
    EXPECT_GT(tally.proven_crossing, 0.99 * tally.crossing);
    EXPECT_GT(tally.proven_apart, 0.99 * tally.apart);
}

// Under poses that are flat, or nearly, in one direction or two, and sizes that are far apart: a flat body's triangles
// are in one plane, and cross nothing that the coordinates of its tree make them seem to cross.
TEST(TrianglePairs, UnderSingularAndUnevenPosesAreSound) {
    scenes::Random random(4);
    Tally tally;
    for (const double thin : {0.0, 0x1p-60, 0x1p-40, 0x1p-30, 0x1p-20, 0x1p-10}) {
        for (int i = 0; i < 120; ++i) {
            const auto pose = [&](double third, double size) {
                Pose p;
                p.R = random.rotation().toRotationMatrix() * size;
                p.R.col(0) *= third;
                if (i % 4 == 0) p.R.col(1) *= third;
                for (int k = 0; k < 3; ++k) p.t[k] = size * random.uniform(-0.2, 0.2);
                return p;
            };
            const double size = i % 5 == 0 ? 0x1p30 : i % 5 == 1 ? 0x1p-30 : 1;
            expect_sound(Body(soup(random, 4, 1), pose(thin, 1)),
                         Body(soup(random, 4, 1), pose(i % 2 == 0 ? 1 : thin, size)), tally);
        }
    }
    EXPECT_GT(tally.crossing, 100);
}

// Needles and specks among them, which are next to each other's planes.
TEST(TrianglePairs, OfHardFamiliesAreSound) {
    scenes::Random random(5);
    Tally tally;
    scenes::for_each_case(scenes::hard_families(), random, 150, [&](const scenes::PosedPair& pair) {
        expect_sound(Body(scenes::one_triangle(pair.a), pair.pose_a), Body(scenes::one_triangle(pair.b), pair.pose_b),
                     tally);
    });
    EXPECT_GT(tally.crossing, 100);
}

// Pairs that only just cross, or only just do not, at two edges: one triangle is moved along a line to where contact
// ends, and then by steps of about the error of the floats.
TEST(TrianglePairs, NextToContactAreSound) {
    scenes::Random random(6);
    Tally tally;
    for (int i = 0; i < 150; ++i) {
        const auto rotation = [&] { return random.turned(); };
        const Body a(soup(random, 1, 1), rotation());
        Body b(soup(random, 1, 1), rotation());
        const auto middle = [](const Body& body) -> Vec3 {
            const auto v = body.mesh->vertices();
            return body.pose.R * (v[0] + v[1] + v[2]) / 3;
        };
        const Vec3 start = middle(a) - middle(b);
        bring_into_contact(a, b, Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1).normalized(), start);
        const Vec3 contact = b.pose.t;
        for (int step = -12; step <= 12; ++step) {
            b.pose.t = contact + std::copysign(std::ldexp(1.0, std::abs(step) - 34), step) * Vec3(0.3, -0.5, 0.8);
            expect_sound(a, b, tally);
        }
    }
    EXPECT_GT(tally.crossing, 300);
    EXPECT_LT(tally.proven_crossing, tally.crossing) << "too far from contact to show anything";
}

}  // namespace
}  // namespace ecods::triangle_pairs_test
