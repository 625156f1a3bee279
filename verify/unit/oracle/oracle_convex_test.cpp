// The oracle's convex solids against numbers that are known, against its own surfaces and solids, and against all
// normals tried one by one in plain integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "oracle/convex.hpp"
#include "oracle/convex_features.hpp"
#include "oracle/solid.hpp"
#include "scenes/convex_cases.hpp"
#include "scenes/each_case.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/lattice_hull.hpp"

namespace ecods::oracle_convex_test {
namespace {

using oracle::ConvexPair;
using oracle::NamedFeature;
using scenes::ConvexCase;
using scenes::LatticeMesh;
using scenes::Random;
using scenes::hard::Int3;

oracle::Soup soup(const scenes::PosedMesh& body) {
    return {body.mesh->vertices(), body.mesh->triangles(), body.pose};
}

ConvexPair pair_of(const ConvexCase& made) {
    return {*made.a.mesh, made.a.pose, *made.b.mesh, made.b.pose};
}

// Those of zero area stick out of their solids.
std::vector<Triangle> triangles_with_area(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (const Triangle& t : mesh.triangles()) {
        const Vec3 u = mesh.vertices()[t[1]] - mesh.vertices()[t[0]], v = mesh.vertices()[t[2]] - mesh.vertices()[t[0]];
        const int exponent = std::ilogb(std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff()));
        const double scale = std::ldexp(1.0, std::min(-exponent, 1000));
        if (!(scale * u).cross(scale * v).isZero(0)) triangles.push_back(t);
    }
    return triangles;
}

bool is_flat(const Mesh& mesh) {
    return oracle::convex_features(mesh)->faces.size() < 2;
}

// The triangles of the set; all of a segment or a point.
std::vector<Triangle> triangles_of_set(const Mesh& mesh) {
    std::vector<Triangle> triangles = triangles_with_area(mesh);
    if (triangles.empty()) triangles.assign(mesh.triangles().begin(), mesh.triangles().end());
    return triangles;
}

// The numbers of all recipes; and the distance of the surfaces and the relation of the solids, which know nothing of
// convexity.
TEST(OracleConvex, EveryFamilyAsItsRecipeAndAsTheSolids) {
    Random random(1);
    scenes::for_each_case(scenes::convex_families(), random, 20, [](const ConvexCase& made) {
        const ConvexPair pair = pair_of(made);
        const double distance = oracle::nearest(pair.distance());
        EXPECT_EQ(made.distance.value_or(distance), distance);
        const auto depth = pair.depth();
        ASSERT_EQ(depth.has_value(), distance == 0);
        if (depth) {
            EXPECT_EQ(made.depth.value_or(oracle::nearest(depth->depth)), oracle::nearest(depth->depth));
        } else {
            const auto of_a = triangles_of_set(*made.a.mesh), of_b = triangles_of_set(*made.b.mesh);
            const oracle::MeshDistances surfaces({made.a.mesh->vertices(), of_a, made.a.pose},
                                                 {made.b.mesh->vertices(), of_b, made.b.pose});
            EXPECT_EQ(compare(surfaces.distance(), pair.distance()), 0);
        }
        if (made.a.mesh->triangles().size() + made.b.mesh->triangles().size() > 60) return;
        if (is_flat(*made.a.mesh) || is_flat(*made.b.mesh)) return;
        const auto relation = oracle::solid_relation(soup(made.a), soup(made.b));
        EXPECT_EQ(relation == Relation::apart, !depth.has_value());
        EXPECT_EQ(relation == Relation::touching, depth && depth->depth.is_zero());
    });
}

// A depth as the root of a quotient.
struct Quotient {
    std::int64_t num = -1, den = 1;
};

std::vector<Int3> corners_of(const LatticeMesh& mesh) {
    std::vector<Int3> corners;
    for (const auto& p : mesh.vertices) corners.push_back({p[0], p[1], p[2]});
    return corners;
}

// Any normal gives a height at which both are parted, the right one the least: none is left out.
void take(const Int3& normal, const std::vector<Int3>& a, const std::vector<Int3>& b, bool& is_apart, Quotient& least) {
    using scenes::hard::dot;
    for (const int sign : {1, -1}) {
        std::int64_t top = INT64_MIN, bottom = INT64_MAX;
        for (const Int3& p : a) top = std::max(top, sign * dot(normal, p));
        for (const Int3& q : b) bottom = std::min(bottom, sign * dot(normal, q));
        const std::int64_t height = top - bottom, square = dot(normal, normal);
        if (square == 0) return;
        is_apart = is_apart || height < 0;
        if (least.num < 0 || height * height * least.den < least.num * square) least = {height * height, square};
    }
}

TEST(OracleConvex, DepthsOfAllNormalsOneByOne) {
    using scenes::hard::cross;
    using scenes::hard::minus;
    Random random(2);
    int deep = 0, apart = 0;
    for (int i = 0; i < 150; ++i) {
        const LatticeMesh mesh_a = scenes::random_lattice_hull(4, 7, random);
        const LatticeMesh mesh_b = scenes::random_lattice_hull(4, 7, random);
        const std::vector<Int3> a = corners_of(mesh_a), b = corners_of(mesh_b);
        std::array<std::vector<Int3>, 2> edges;
        Quotient least;
        bool is_apart = false;
        for (const auto& [mesh, points, list] :
             {std::tuple(&mesh_a, &a, &edges[0]), std::tuple(&mesh_b, &b, &edges[1])}) {
            for (const Triangle& t : mesh->triangles) {
                const Int3 u = minus((*points)[t[1]], (*points)[t[0]]), v = minus((*points)[t[2]], (*points)[t[0]]);
                take(cross(u, v), a, b, is_apart, least);
                for (const Int3& edge : {u, v, minus(v, u)}) list->push_back(edge);
            }
        }
        for (const Int3& u : edges[0]) {
            for (const Int3& v : edges[1]) take(cross(u, v), a, b, is_apart, least);
        }
        const auto depth = ConvexPair(*scenes::to_mesh(mesh_a, 1), Pose(), *scenes::to_mesh(mesh_b, 1), Pose()).depth();
        ASSERT_EQ(depth.has_value(), !is_apart);
        (is_apart ? apart : deep) += 1;
        if (!depth) continue;
        const oracle::ExactRoot expected{static_cast<long>(least.num), static_cast<long>(least.den), 0};
        ASSERT_EQ(compare(depth->depth, expected), 0) << i;
    }
    EXPECT_GT(deep, 50);
    EXPECT_GT(apart, 5);
}

// Moves by integers: the interiors share no point just when the solids, moved, touch or are apart.
TEST(OracleConvex, WhatPartsThemAsTheSolidsSay) {
    Random random(3);
    std::array<int, 2> counts{};
    for (int i = 0; i < 60; ++i) {
        const auto a = scenes::to_mesh(scenes::random_lattice_hull(3, 6, random), 1);
        const auto b = scenes::to_mesh(scenes::random_lattice_hull(3, 6, random), 1);
        const ConvexPair pair(*a, Pose(), *b, Pose());
        const Vec3 move(scenes::hard::integer(random, -5, 5), scenes::hard::integer(random, -5, 5),
                        scenes::hard::integer(random, -5, 5));
        Pose moved;
        moved.t = move;
        const auto relation = oracle::solid_relation(soup({a, Pose()}), soup({b, moved}));
        const bool are_parted = relation <= Relation::touching;
        EXPECT_EQ(pair.are_parted_by(move), are_parted);
        ++counts[are_parted ? 1 : 0];
        if (pair.is_beyond_depth(move)) {
            EXPECT_TRUE(are_parted);
        }
        if (!are_parted || !pair.share_a_point()) continue;
        EXPECT_GE(pair.compare_to_depth(move), 0);
    }
    for (const int count : counts) EXPECT_GT(count, 10);
}

TEST(OracleConvex, FeaturesAreThoseOfTheSet) {
    Random random(4);
    for (int i = 0; i < 60; ++i) {
        const LatticeMesh coarse = scenes::random_lattice_hull(3, 8, random);
        const auto mesh = scenes::to_mesh(coarse, 1), fine = scenes::to_mesh(scenes::refined(coarse), 1);
        const auto features = oracle::convex_features(*mesh), same = oracle::convex_features(*fine);
        ASSERT_TRUE(features && same);
        EXPECT_EQ(features->vertices.size() - features->edges.size() + features->faces.size(), 2U);
        EXPECT_EQ(features->vertices.size(), coarse.vertices.size());
        EXPECT_EQ(features->vertices.size(), same->vertices.size());
        EXPECT_EQ(features->edges.size(), same->edges.size());
        EXPECT_EQ(features->faces.size(), same->faces.size());
    }
    // Of a cube the diagonals are no edges.
    const auto cube = oracle::convex_features(*scenes::to_mesh(scenes::box({0, 0, 0}, {1, 1, 1}), 1));
    EXPECT_EQ(cube->vertices.size(), 8U);
    EXPECT_EQ(cube->edges.size(), 12U);
    EXPECT_EQ(cube->faces.size(), 6U);
    EXPECT_EQ(cube->faces.front().name, (NamedFeature{2, 0, 0}));
    EXPECT_EQ(cube->vertices.front().name, (NamedFeature{0, 0, 0}));
    EXPECT_FALSE(oracle::convex_features(
        *scenes::to_mesh(scenes::boundary({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, false, random), 1)));
}

TEST(OracleConvex, HullsAsThoseOfTheLattice) {
    Random random(5);
    for (int i = 0; i < 60; ++i) {
        std::vector<scenes::LatticePoint> points(5 + random.below(6));
        std::vector<Vec3> doubles;
        for (auto& p : points) {
            for (int& x : p) x = scenes::hard::integer(random, -2, 2);
            doubles.emplace_back(p[0], p[1], p[2]);
        }
        const LatticeMesh expected = scenes::lattice_hull(points);
        const auto hull = oracle::hull_of(doubles);
        ASSERT_TRUE(hull);
        if (expected.triangles.empty()) {  // all points lie in one plane
            EXPECT_EQ(hull->triangles.size(), std::max<std::size_t>(hull->points.size(), 3) - 2);
            continue;
        }
        EXPECT_EQ(hull->points.size(), expected.vertices.size());
        EXPECT_EQ(hull->triangles.size(), expected.triangles.size());
    }
}

// Two cubes, b higher by 3/4: a's upper face goes first, although b's lower one has the same normal.
TEST(OracleConvex, FacesOfTheFirstGoFirst) {
    const LatticeMesh unit = scenes::box({0, 0, 0}, {1, 1, 1});
    const auto cube = scenes::to_mesh(unit, 1);
    Pose above;
    above.t = Vec3(0, 0.125, 0.75);
    const ConvexPair pair(*cube, Pose(), *cube, above);
    const auto depth = pair.depth();
    EXPECT_EQ(oracle::nearest(depth->depth), 0.25);
    EXPECT_EQ(depth->normal.nearest(), Vec3(0, 0, 1));
    EXPECT_EQ(pair.depth_tie_count(), 1U);
    const auto same = ConvexPair(*cube, Pose(), *cube, Pose());
    EXPECT_EQ(same.depth_tie_count(), 6U);
    EXPECT_EQ(same.depth()->a, (NamedFeature{2, 0, 0}));
}

}  // namespace
}  // namespace ecods::oracle_convex_test
