// The oracle against clipping in rational numbers: on the lattice, on every family of hard pairs, on degenerate ones
// and on meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "clipped_pair.hpp"
#include "convex_pair.hpp"
#include "exhaustive/lattice.hpp"
#include "oracle/oracle.hpp"
#include "scenes/hard_pairs.hpp"

namespace ecods::oracle::oracle_clipping_test {
namespace {

using lattice::Corners;
using lattice::positions;
using TrianglePoints = std::array<clipping::Point, 3>;

// A representative of each orbit of the cube's 48 symmetries.
std::vector<Corners> representatives(const std::vector<Corners>& triangles) {
    const auto symmetries = lattice::all_symmetries();
    std::vector<Corners> result;
    for (const Corners& corners : triangles) {
        const bool is_least = std::ranges::all_of(
            symmetries, [&](const auto& symmetry) { return corners <= lattice::apply(symmetry, corners); });
        if (is_least) result.push_back(corners);
    }
    return result;
}

bool is_degenerate(const Corners& corners) {
    const auto p = positions(corners);
    return (p[1] - p[0]).cross(p[2] - p[0]).isZero();
}

TrianglePoints exact(const std::array<Vec3, 3>& corners) {
    const Pose nowhere;
    return {clipping::posed(nowhere, corners[0]), clipping::posed(nowhere, corners[1]),
            clipping::posed(nowhere, corners[2])};
}

struct Tally {
    std::array<int, 3> of_relation{};
    int differing = 0;

    void add(Relation expected, Relation got) {
        ++of_relation[static_cast<std::size_t>(expected)];
        differing += expected != got;
    }
};

// Up to symmetry every pair of the lattice is in here, for one in `step` of the second triangles.
Tally compare_lattice(const std::vector<Corners>& first, const std::vector<Corners>& second, std::size_t step) {
    const Pose nowhere;
    std::vector<TrianglePoints> points;
    for (const Corners& b : second) points.push_back(exact(positions(b)));
    Tally tally;
    std::size_t at = 0;
    for (const Corners& a : first) {
        const TrianglePoints exact_a = exact(positions(a));
        // Another part of the second triangles each time.
        for (std::size_t i = at++ % step; i < second.size(); i += step) {
            tally.add(clipping::relation(exact_a, points[i]),
                      triangle_triangle(nowhere, positions(a), nowhere, positions(second[i])));
        }
    }
    return tally;
}

TEST(OracleClipping, LatticePairs) {
    const auto triangles = lattice::all_triangles();
    const Tally tally = compare_lattice(representatives(triangles), triangles, 8);
    EXPECT_EQ(tally.differing, 0);
    for (const int count : tally.of_relation) EXPECT_GT(count, 1000);
}

TEST(OracleClipping, DegenerateLatticePairs) {
    std::vector<Corners> degenerate = lattice::all_triangles();
    std::erase_if(degenerate, [](const Corners& corners) { return !is_degenerate(corners); });
    ASSERT_EQ(degenerate.size(), 778u);
    const Tally tally = compare_lattice(representatives(degenerate), degenerate, 1);
    EXPECT_EQ(tally.differing, 0);
    EXPECT_GT(tally.of_relation[0], 1000);
    EXPECT_GT(tally.of_relation[1], 1000);
    EXPECT_EQ(tally.of_relation[2], 0) << "two segments lie in a plane or do not meet";
}

TEST(OracleClipping, HardPairs) {
    scenes::Random random(51);
    for (const auto& family : scenes::hard_families()) {
        Tally tally;
        for (int i = 0; i < 150; ++i) {
            scenes::PosedPair pair = family.make(random);
            // Every third pair has a triangle without area in it.
            if (i % 3 == 1) pair.a[2] = pair.a[static_cast<std::size_t>(i % 2)];
            if (i % 3 == 2) pair.b[0] = 0.5 * pair.b[1] + 0.5 * pair.b[2];
            const Relation expected = clipping::relation(pair.pose_a, pair.a, pair.pose_b, pair.b);
            tally.add(expected, triangle_triangle(pair.pose_a, pair.a, pair.pose_b, pair.b));
            tally.add(expected, triangle_triangle(pair.pose_b, pair.b, pair.pose_a, pair.a));
            // In the other order, other points are clipped by other functions.
            ASSERT_EQ(clipping::relation(pair.pose_b, pair.b, pair.pose_a, pair.a), expected);
        }
        EXPECT_EQ(tally.differing, 0) << family.name;
    }
}

// The two that judge the oracle agree with each other, which is no part of the oracle's test but of theirs.
TEST(OracleClipping, AgreesWithLinearPrograms) {
    const auto triangles = lattice::all_triangles();
    scenes::Random random(52);
    const Pose nowhere;
    for (int i = 0; i < 300; ++i) {
        const auto any = [&] {
            return positions(triangles[random.below(static_cast<std::uint32_t>(triangles.size()))]);
        };
        const auto a = any(), b = any();
        ASSERT_EQ(clipping::relation(nowhere, a, nowhere, b), model::relation(nowhere, a, nowhere, b));
    }
}

TEST(OracleClipping, Meshes) {
    scenes::Random random(53);
    std::size_t touching = 0;
    for (int i = 0; i < 40; ++i) {
        const auto soup = [&] {
            std::vector<Vec3> vertices(6);
            for (Vec3& v : vertices) v = Vec3(random.below(4), random.below(4), random.below(4));
            std::vector<Triangle> triangles(10);
            for (Triangle& t : triangles) t = {random.below(6), random.below(6), random.below(6)};
            return Mesh::create(std::move(vertices), std::move(triangles));
        };
        const auto a = soup(), b = soup();
        Pose pose_a = random.turned(), pose_b;
        pose_b.R = i % 2 == 0 ? pose_a.R : random.rotation().toRotationMatrix();
        pose_b.t = pose_a.R * Vec3(1, 0, 0);
        Verdict expected;
        for (std::uint32_t x = 0; x < 10; ++x) {
            for (std::uint32_t y = 0; y < 10; ++y) {
                const auto corners = [](const Mesh& mesh, std::uint32_t t) -> std::array<Vec3, 3> {
                    const Triangle& index = mesh.triangles()[t];
                    return {mesh.vertices()[index[0]], mesh.vertices()[index[1]], mesh.vertices()[index[2]]};
                };
                const Relation relation = clipping::relation(pose_a, corners(*a, x), pose_b, corners(*b, y));
                expected.relation = std::max(expected.relation, relation);
                if (relation != Relation::apart) expected.triangles.push_back({x, y});
            }
        }
        const Verdict got = verdict({a, pose_a}, {b, pose_b});
        EXPECT_EQ(got.relation, expected.relation);
        EXPECT_EQ(got.triangles, expected.triangles);
        touching += expected.triangles.size();
    }
    EXPECT_GT(touching, 200u);
}

}  // namespace
}  // namespace ecods::oracle::oracle_clipping_test
