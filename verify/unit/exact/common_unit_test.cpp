// Points whose coordinates are short multiples of one length on each axis: counted in these lengths, plain double is
// exact.

#include "exact/number/common_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/oracle.hpp"
#include "query/intersection/triangle_relations.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::exact::common_unit_test {
namespace {

using scenes::Random;

CommonUnit unit_of(std::initializer_list<double> numbers) {
    CommonUnit unit;
    for (const double x : numbers) unit.include(decode(x));
    return unit;
}

TEST(CommonUnit, OfNumbers) {
    const auto expect = [](const CommonUnit& unit, std::uint64_t m, int e) {
        EXPECT_EQ(unit.m, m);
        EXPECT_EQ(unit.e, e);
    };
    expect(unit_of({}), 0, 0);
    expect(unit_of({0, -0.0}), 0, 0);
    expect(unit_of({-12}), 3, 2);
    expect(unit_of({0, 15, -0.75}), 3, -2);
    expect(unit_of({-0.75, 15, 0}), 3, -2);
    expect(unit_of({6, 35}), 1, 0);
    expect(unit_of({0x1p-1074, 0x1p1000}), 1, -1074);
    expect(unit_of({0.1, 0.2, 0.4}), decode(0.1).m, decode(0.1).e);
    CommonUnit products;
    products.include(decode(-6.0), unit_of({35, 14}));  // multiples of 42
    products.include(decode(0.0), unit_of({1}));
    products.include(decode(1.0), CommonUnit{});
    expect(products, 21, 1);
    products.include(DyadicDifference{-Int128{63} << 70, -80});
    products.include(DyadicDifference{});
    expect(products, 21, -10);
}

// A length that is not short: an odd number of `bits` bits.
double length(Random& random, int bits) {
    return std::floor(random.uniform(std::ldexp(1.0, bits - 2), std::ldexp(1.0, bits - 1))) * 2 + 1;
}

Mat3 signed_permutation(Random& random) {
    Mat3 R = Mat3::Zero();
    const auto shift = random.below(3);
    const bool is_odd = random.below(2) == 0;
    for (std::uint32_t i = 0; i < 3; ++i) R(i, (shift + (is_odd ? 2 - i : i)) % 3) = random.below(2) == 0 ? 1 : -1;
    return R;
}

Vec3 integers(Random& random, double max) {
    Vec3 v;
    for (int k = 0; k < 3; ++k) v[k] = std::floor(random.uniform(-max, max));
    return v;
}

struct Body {
    std::shared_ptr<const Mesh> mesh;
    MeshExtent extent;
    Pose pose;

    // At these places in the world, which R and t reach without rounding.
    Body(const Mat3& R, const Vec3& t, std::vector<Vec3> places, const std::vector<Triangle>& triangles) {
        pose.R = R;
        pose.t = t;
        for (Vec3& p : places) p = R.transpose() * (p - t);
        mesh = Mesh::create(std::move(places), triangles);
        extent = measure(*mesh);
    }
    std::array<Vec3, 3> corners(std::uint32_t triangle) const {
        const Triangle& t = mesh->triangles()[triangle];
        return {mesh->vertices()[t[0]], mesh->vertices()[t[1]], mesh->vertices()[t[2]]};
    }
    BodyRef side() const { return {mesh.get(), &extent, &pose}; }
};

// Triangles with a vertex of the other one in their interior, of every size: from short in units, past the limit, to
// numbers that need more than the digits of a double.
TEST(CommonUnit, AnswersDoNotDependOnTheSize) {
    Random random(71);
    TriangleRelations bodies;
    std::array<std::uint64_t, 25> plain{}, one_limb{};
    for (int bits = 2; bits < 25; ++bits) {
        bodies.reset_counts();
        for (int i = 0; i < 400; ++i) {
            const double max = std::ldexp(1.0, bits);
            const double scale = std::ldexp(1.0, static_cast<int>(random.below(300)) - 200);
            Vec3 unit;
            for (int k = 0; k < 3; ++k) unit[k] = scale * length(random, 2 + static_cast<int>(random.below(23)));
            const Vec3 p = integers(random, max / 6), q = integers(random, max / 6);
            const Vec3 tip = p + q, step = (i % 2) * integers(random, 2);
            const auto at = [&](const Vec3& n) -> Vec3 { return n.cwiseProduct(unit); };
            const Body a(signed_permutation(random), at(integers(random, max)),
                         {at(Vec3::Zero()), at(3 * p), at(3 * q)}, {{0, 1, 2}});
            const Body b(signed_permutation(random), at(integers(random, max)),
                         {at(tip + step), at(tip + integers(random, max / 4)), at(tip + integers(random, max / 4))},
                         {{0, 1, 2}});
            const Relation expected = oracle::triangle_triangle(a.pose, a.corners(0), b.pose, b.corners(0));
            bodies.bind(a.side(), b.side());
            ASSERT_EQ(bodies.relation(0, 0), expected) << bits << " " << i;
            ASSERT_EQ(bodies.relation(0, 0), expected) << "counted, from the start";
            bodies.bind(b.side(), a.side());
            ASSERT_EQ(bodies.relation(0, 0), expected) << bits << " " << i;
        }
        plain[static_cast<std::size_t>(bits)] = bodies.counts().local_passes;
        one_limb[static_cast<std::size_t>(bits)] = bodies.counts().one_limb;
    }
    EXPECT_GT(plain[10], 600u);
    EXPECT_EQ(plain[24], 0u);
    EXPECT_EQ(one_limb[10], 0u);
    EXPECT_GT(one_limb[24], 300u);
}

// Cubes of a length with 40 digits, side by side under permutation matrices.
TEST(CommonUnit, GridsOfOneLength) {
    Random random(72);
    for (int i = 0; i < 60; ++i) {
        const Vec3 unit{length(random, 40), length(random, 38), i % 3 == 0 ? 1.0 : length(random, 41)};
        const auto cube_at = [&](const Vec3& n) {
            std::vector<Vec3> places;
            for (int corner = 0; corner < 8; ++corner) {
                places.push_back((n + Vec3(corner & 1, corner >> 1 & 1, corner >> 2))
                                     .cwiseProduct(i % 5 == 0 ? Vec3(unit[0], unit[1], 0) : unit));
            }
            // One corner is off by the last digit: no common length of that size.
            if (i % 4 == 3) places[7] += Vec3::Ones();
            const auto cube = scenes::cube(1);
            return Body(signed_permutation(random), n.cwiseProduct(unit), places,
                        {cube->triangles().begin(), cube->triangles().end()});
        };
        const Vec3 cell = integers(random, 4);
        const Body a = cube_at(cell), b = cube_at(cell + integers(random, 2));
        TriangleRelations bodies;
        bodies.bind(a.side(), b.side());
        for (std::uint32_t t = 0; t < 12; ++t) {
            for (std::uint32_t u = 0; u < 12; ++u) {
                const Relation expected = oracle::triangle_triangle(a.pose, a.corners(t), b.pose, b.corners(u));
                ASSERT_EQ(bodies.relation(t, u), expected) << i << " " << t << " " << u;
            }
        }
        const StageCounts& counts = bodies.counts();
        if (i % 4 != 3) {
            EXPECT_EQ(counts.filter_passes + counts.local_passes, counts.triangle_tests) << i;
        } else {
            EXPECT_EQ(counts.local_passes, 0u) << i;
        }
    }
}

}  // namespace
}  // namespace ecods::exact::common_unit_test
