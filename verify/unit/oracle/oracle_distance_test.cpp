// The oracle's distances against answers that are known without it, and against a proof of each.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "exact_vector.hpp"
#include "oracle/distance.hpp"
#include "oracle/oracle.hpp"
#include "scenes/each_case.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/shapes.hpp"

namespace ecods::oracle::oracle_distance_test {
namespace {

using Corners = std::array<Vec3, 3>;
const std::vector<Triangle> one_triangle{{0, 1, 2}};

MeshDistances distances_of(const Corners& a, const Pose& pose_a, const Corners& b, const Pose& pose_b) {
    return {{a, one_triangle, pose_a}, {b, one_triangle, pose_b}};
}

// A matrix of integers: the length of all that it turns is multiplied by its norm, m^2 + a^2 + b^2 + c^2.
struct IntegerRotation {
    Mat3 R;
    double norm = 0;

    IntegerRotation(int m, int a, int b, int c) : norm(m * m + a * a + b * b + c * c) {
        R << m * m + a * a - b * b - c * c, 2 * (a * b - m * c), 2 * (a * c + m * b),  //
            2 * (a * b + m * c), m * m - a * a + b * b - c * c, 2 * (b * c - m * a),   //
            2 * (a * c - m * b), 2 * (b * c + m * a), m * m - a * a - b * b + c * c;
    }
};

const IntegerRotation rotations[] = {{1, 0, 0, 0},  {1, 1, 0, 0},  {1, 2, 0, 1},
                                     {2, -1, 3, 1}, {5, 2, -4, 7}, {1, 1, 1, 1}};

// Both triangles in one integer rotation, and at any place: distance and features are as they were.
void expect_everywhere(const Corners& a, const Corners& b, double distance, Closeness kind, NamedFeature feature_a,
                       NamedFeature feature_b) {
    for (const IntegerRotation& rotation : rotations) {
        for (const double scale : {1.0, 0x1p-900, 0x1p900}) {
            Pose pose{rotation.R * scale, scale * Vec3(1e5, -3, 7)};
            const ExactClosest closest = distances_of(a, pose, b, pose).closest();
            const double expected = distance * rotation.norm * scale;
            EXPECT_EQ(compare(closest.distance, expected), 0);
            EXPECT_EQ(nearest(closest.distance), expected);
            EXPECT_EQ(closest.kind, kind);
            EXPECT_EQ(closest.a, feature_a) << closest.a.dimension << closest.a.corner;
            EXPECT_EQ(closest.b, feature_b) << closest.b.dimension << closest.b.corner;
        }
    }
}

const Corners floor_triangle{Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(0, 9, 0)};

TEST(OracleDistance, LatticeFeaturesAtIntegerDistances) {
    const auto vertex = [](std::uint32_t corner) { return NamedFeature{0, 0, corner}; };
    const auto edge = [](std::uint32_t corner) { return NamedFeature{1, 0, corner}; };
    const NamedFeature face{2, 0, 0};
    expect_everywhere(floor_triangle, {Vec3(5, 8, 20), Vec3(2, 3, 7), Vec3(8, 2, 11)}, 7, Closeness::vertex_face, face,
                      vertex(1));
    expect_everywhere({Vec3(5, 8, 20), Vec3(8, 2, 11), Vec3(2, 3, 7)}, floor_triangle, 7, Closeness::vertex_face,
                      vertex(2), face);
    // Above and beside an edge: 3, 4, 5.
    expect_everywhere(floor_triangle, {Vec3(4, -3, 4), Vec3(0, -9, 9), Vec3(9, -9, 9)}, 5, Closeness::vertex_edge,
                      edge(0), vertex(0));
    expect_everywhere(floor_triangle, {Vec3(-12, 1, 20), Vec3(-3, 7, 4), Vec3(-9, 9, 9)}, 5, Closeness::vertex_edge,
                      edge(2), vertex(1));
    // Beyond a corner: 2, 3, 6 and 7.
    expect_everywhere(floor_triangle, {Vec3(-9, -9, 9), Vec3(-9, -4, 19), Vec3(-2, -3, 6)}, 7, Closeness::vertex_vertex,
                      vertex(0), vertex(2));
    // Edges that cross, one above the other.
    expect_everywhere({Vec3(0, -5, 0), Vec3(0, 5, 0), Vec3(-5, 0, -9)}, {Vec3(5, 0, 12), Vec3(-3, 0, 3), Vec3(4, 0, 3)},
                      3, Closeness::edge_edge, edge(0), edge(1));
}

// The foot at p / q of an edge, for every such fraction.
TEST(OracleDistance, VerticesAtFractionsOfAnEdge) {
    for (int q = 2; q < 12; ++q) {
        for (int p = 1; p < q; ++p) {
            const Vec3 direction(2, 3, 6), across(3, -2, 0), from(1, 1, 1);  // at right angles; 7 and the root of 13
            const Corners a{from, from + q * direction, from + q * direction - across};
            const Vec3 above = from + p * direction + 5 * across;
            const Corners b{above, above + 9 * across, above + 9 * across + direction};
            const ExactClosest closest = distances_of(a, {}, b, {}).closest();
            EXPECT_EQ(closest.kind, Closeness::vertex_edge);
            EXPECT_EQ(compare(closest.distance, ExactRoot{25 * 13, 1, 0}), 0);
            EXPECT_EQ(closest.point_a.nearest(), Vec3(from + p * direction));
            EXPECT_EQ(closest.point_b.nearest(), above);
        }
    }
}

// Parallel faces and edges, and corners that are there several times: the first of many.
TEST(OracleDistance, TheRuleAmongTies) {
    const Pose up{Mat3::Identity(), Vec3(0, 0, 5)};
    const ExactClosest same = distances_of(floor_triangle, {}, floor_triangle, up).closest();
    EXPECT_EQ(same.kind, Closeness::vertex_vertex);
    EXPECT_EQ(same.a, (NamedFeature{0, 0, 0}));
    EXPECT_EQ(same.b, (NamedFeature{0, 0, 0}));
    EXPECT_EQ(nearest(same.distance), 5);
    // All of the small one lies above the inside of the large one.
    const Corners small{Vec3(2, 2, 5), Vec3(3, 2, 5), Vec3(2, 3, 5)};
    const ExactClosest inside = distances_of(floor_triangle, {}, small, {}).closest();
    EXPECT_EQ(inside.kind, Closeness::vertex_face);
    EXPECT_EQ(inside.b, (NamedFeature{0, 0, 0}));
    EXPECT_EQ(inside.point_a.nearest(), Vec3(2, 2, 0));
    // Parallel edges that overlap: a corner of each is before the inside of an edge of the other; a's comes first.
    const Corners b{Vec3(5, -2, 0), Vec3(-3, -2, 0), Vec3(0, -9, 0)};
    const ExactClosest parallel = distances_of(floor_triangle, {}, b, {}).closest();
    EXPECT_EQ(parallel.kind, Closeness::vertex_edge);
    EXPECT_EQ(parallel.a, (NamedFeature{0, 0, 0}));
    EXPECT_EQ(parallel.b, (NamedFeature{1, 0, 0}));
    // A segment written as a triangle, its middle corner nearest: a vertex is before an edge.
    const Corners segment{Vec3(-5, 0, 3), Vec3(5, 0, 3), Vec3(0, 0, 3)};
    const Corners point{Vec3(0, 0, 7), Vec3(0, 0, 7), Vec3(0, 0, 7)};
    const ExactClosest middle = distances_of(segment, {}, point, {}).closest();
    EXPECT_EQ(middle.kind, Closeness::vertex_vertex);
    EXPECT_EQ(middle.a, (NamedFeature{0, 0, 2}));
    EXPECT_EQ(middle.b, (NamedFeature{0, 0, 0}));
}

// What proves that two points are the closest ones of two convex sets: they belong to them, and no corner lies beyond
// the planes through them at right angles to their difference.
void expect_proof(const ExactClosest& closest, const std::array<ExactVector, 3>& a,
                  const std::array<ExactVector, 3>& b) {
    const ExactVector p = exact_vector(closest.point_a), q = exact_vector(closest.point_b);
    EXPECT_TRUE(lies_inside(p, a, closest.a.dimension, closest.a.corner));
    EXPECT_TRUE(lies_inside(q, b, closest.b.dimension, closest.b.corner));
    const ExactVector w = q - p;
    for (const ExactVector& corner : a) EXPECT_LE(w.dot(corner - p), 0);
    for (const ExactVector& corner : b) EXPECT_GE(w.dot(corner - q), 0);
    EXPECT_EQ(w.dot(w), square_of(closest.distance));
}

TEST(OracleDistance, EveryAnswerIsProved) {
    int i = 0;
    scenes::for_each_case(scenes::hard_families(), 7, 150, [&](scenes::PosedPair pair) {
        if (i++ % 3 == 1) pair.pose_b.t += pair.pose_b.R * pair.b[0];
        const MeshDistances distances = distances_of(pair.a, pair.pose_a, pair.b, pair.pose_b);
        const ExactClosest closest = distances.closest();
        const Relation relation = triangle_triangle(pair.pose_a, pair.a, pair.pose_b, pair.b);
        ASSERT_EQ(closest.kind == Closeness::intersecting, relation != Relation::apart);
        ASSERT_EQ(closest.distance.is_zero(), relation != Relation::apart);
        ASSERT_EQ(distances.intersection(0, 0).empty(), relation == Relation::apart);
        if (relation != Relation::apart) return;
        expect_proof(closest, exact_corners(pair.pose_a, pair.a), exact_corners(pair.pose_b, pair.b));
        const double rounded = nearest(closest.distance);
        ASSERT_TRUE(is_nearest(closest.distance, rounded));
        ASSERT_FALSE(is_nearest(closest.distance, std::nextafter(rounded, 0.0)));
        ASSERT_FALSE(is_nearest(closest.distance, std::nextafter(rounded, HUGE_VAL)));
    });
}

// Known by drawing them.
TEST(OracleDistance, CornersOfWhatTwoTrianglesShare) {
    const Corners large{Vec3(-2, -2, 0), Vec3(4, -2, 0), Vec3(-2, 4, 0)};
    const auto shared = [&](const Corners& other) {
        std::vector<Vec3> corners;
        for (const ExactPoint& corner : distances_of(large, {}, other, {}).intersection(0, 0)) {
            corners.push_back(corner.nearest());
        }
        return corners;
    };
    using Points = std::vector<Vec3>;
    EXPECT_EQ(shared({Vec3(0, 0, 0), Vec3(0, 0, 5), Vec3(0, 2, 5)}), Points{Vec3(0, 0, 0)});
    EXPECT_EQ(shared({Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, 0, 1)}), (Points{{0, 0, 0}, {0.5, 0, 0}}));
    EXPECT_EQ(shared({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}), (Points{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(shared({Vec3(2, 2, 0), Vec3(-4, 2, 0), Vec3(2, -4, 0)}),
              (Points{{-2, 0, 0}, {-2, 2, 0}, {0, -2, 0}, {0, 2, 0}, {2, -2, 0}, {2, 0, 0}}))
        << "a hexagon";
    // Segments and points.
    EXPECT_EQ(shared({Vec3(-5, 0, 0), Vec3(0, 0, 0), Vec3(5, 0, 0)}), (Points{{-2, 0, 0}, {2, 0, 0}}));
    EXPECT_EQ(shared({Vec3(0, 0, -5), Vec3(0, 0, 1), Vec3(0, 0, 5)}), Points{Vec3(0, 0, 0)});
    EXPECT_EQ(shared({Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 0)}), Points{Vec3(1, 1, 0)});
    EXPECT_EQ(shared({Vec3(1, 1, 0x1p-1074), Vec3(1, 1, 1), Vec3(1, 1, 1)}), Points{});
}

// Blocks and intervals leave nothing out: all pairs of triangles, one by one.
TEST(OracleDistance, OfMeshesAsOfAllPairs) {
    const auto mesh_a = scenes::torus(9, 5, 0.4), mesh_b = scenes::cube(0.5);
    scenes::Random random(11);
    for (int i = 0; i < 20; ++i) {
        Pose a = random.turned(), b;
        b.t = random.direction() * random.uniform(1, 3);
        if (i % 2 == 1) b.R = a.R;
        const MeshDistances distances({mesh_a->vertices(), mesh_a->triangles(), a},
                                      {mesh_b->vertices(), mesh_b->triangles(), b});
        const ExactClosest closest = distances.closest();
        const double limit = 1.2 * nearest(closest.distance);
        const auto close = distances.close_triangles(limit);
        std::size_t at = 0;
        for (std::uint32_t s = 0; s < mesh_a->triangles().size(); ++s) {
            for (std::uint32_t t = 0; t < mesh_b->triangles().size(); ++t) {
                const ExactRoot one = distances.distance(s, t);
                EXPECT_GE(compare(one, closest.distance), 0);
                if (compare(one, limit) > 0) continue;
                ASSERT_LT(at, close.size());
                EXPECT_EQ(close[at].a.triangle, s);
                EXPECT_EQ(close[at].b.triangle, t);
                EXPECT_EQ(compare(close[at++].distance, one), 0);
            }
        }
        EXPECT_EQ(at, close.size());
        EXPECT_EQ(compare(distances.distance(), closest.distance), 0);
        EXPECT_TRUE(distances.within(limit));
        EXPECT_EQ(distances.within(0), closest.distance.is_zero());
    }
}

TEST(OracleDistance, CubesFaceToFaceInAnyRotation) {
    const auto cube = scenes::cube(0.5);
    for (const IntegerRotation& rotation : rotations) {
        Pose a{rotation.R, Vec3(1, 2, 3)}, b = a;
        b.t += rotation.R * Vec3(3, 0.25, 0);
        const MeshDistances distances({cube->vertices(), cube->triangles(), a},
                                      {cube->vertices(), cube->triangles(), b});
        EXPECT_EQ(compare(distances.distance(), 2 * rotation.norm), 0);
        EXPECT_TRUE(distances.within(2 * rotation.norm));
        EXPECT_FALSE(distances.within(std::nextafter(2 * rotation.norm, 0.0)));
    }
}

TEST(OracleNearest, RootsOfSquaresAndHalfWayPoints) {
    for (const double x : {1.0, 3.0, 0x1.fffffffffffffp0, 0x1p-1074, 0x1.8p-1070, 0x1.fffffffffffffp1023, 0x1p-1022}) {
        int exponent = 0;
        const mpz_class digits = static_cast<unsigned long>(std::ldexp(std::frexp(x, &exponent), 53));
        const ExactRoot exact{digits * digits, 1, exponent - 53};
        EXPECT_EQ(compare(exact, x), 0);
        EXPECT_EQ(nearest(exact), x);
        // Half-way to the next, and a hair above and below.
        const double next = std::nextafter(x, HUGE_VAL);
        const bool is_subnormal = x < 0x1p-1022;
        const long unit = is_subnormal ? -1075 : exponent - 54;
        mpz_class half = is_subnormal ? mpz_class(2 * std::ldexp(x, 1074) + 1) : mpz_class(2 * digits + 1);
        const bool is_even = is_subnormal ? std::fmod(std::ldexp(x, 1074), 2) == 0 : digits % 2 == 0;
        EXPECT_EQ(nearest(ExactRoot{half * half, 1, unit}), is_even ? x : next);
        half <<= 400;
        EXPECT_EQ(nearest(ExactRoot{half * half - 1, 1, unit - 400}), x);
        EXPECT_EQ(nearest(ExactRoot{half * half + 1, 1, unit - 400}), next);
    }
    EXPECT_EQ(nearest(ExactRoot{1, 1, -5000}), 0x1p-1074) << "positive is not zero";
    EXPECT_EQ(nearest(ExactRoot{1, 1, 5000}), HUGE_VAL);
    EXPECT_EQ(nearest(ExactRoot{0, 1, 0}), 0.0);
    EXPECT_EQ(nearest(ExactRoot{2, 1, 0}), 0x1.6a09e667f3bcdp0);
}

TEST(OracleNearest, Fractions) {
    EXPECT_EQ(nearest(ExactFraction{1, 3, 0}), 1.0 / 3);
    EXPECT_EQ(nearest(ExactFraction{-2, 3, 0}), -2.0 / 3);
    EXPECT_EQ(nearest(ExactFraction{1, 1, -1075}), 0.0) << "a tie, and zero is even";
    EXPECT_EQ(nearest(ExactFraction{3, 1, -1075}), 0x1p-1073);
    EXPECT_FALSE(std::signbit(nearest(ExactFraction{-1, 1, -1075})));
    EXPECT_TRUE(is_nearest(ExactFraction{-1, 1, -1075}, 0.0));
    EXPECT_FALSE(is_nearest(ExactFraction{-1, 1, -1075}, -0.0));
    EXPECT_FALSE(is_nearest(ExactFraction{-1, 1, 0}, 1));
    EXPECT_EQ(nearest(ExactFraction{-1, 1, 1024}), -HUGE_VAL);
}

TEST(OracleDistance, TheEnvironmentDoesNotMatterAndStays) {
    scenes::Random random(5);
    for (int i = 0; i < 40; ++i) {
        const auto pair = scenes::family_named(scenes::hard_families(), "generic").make(random);
        const double expected = nearest(distances_of(pair.a, pair.pose_a, pair.b, pair.pose_b).distance());
        for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            std::fesetround(mode);
            const double got = nearest(distances_of(pair.a, pair.pose_a, pair.b, pair.pose_b).distance());
            const int after = std::fegetround();
            std::fesetround(FE_TONEAREST);
            EXPECT_EQ(got, expected);
            EXPECT_EQ(after, mode);
        }
    }
}

}  // namespace
}  // namespace ecods::oracle::oracle_distance_test
