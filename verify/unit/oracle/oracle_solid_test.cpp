// The oracle's solids against solids whose answers follow from how they are made.
#include <gtest/gtest.h>

#include "oracle/solid.hpp"
#include "scenes/each_case.hpp"
#include "scenes/shapes.hpp"
#include "scenes/solid_cases.hpp"

namespace ecods::oracle_solid_test {
namespace {

oracle::Soup soup(const scenes::PosedMesh& body) {
    return {body.mesh->vertices(), body.mesh->triangles(), body.pose};
}

Relation solid_relation(const scenes::PosedMesh& a, const scenes::PosedMesh& b) {
    return oracle::solid_relation(soup(a), soup(b));
}

Relation mirrored(Relation relation) {
    return relation == Relation::inside     ? Relation::contains
           : relation == Relation::contains ? Relation::inside
                                            : relation;
}

void expect_solid(const Mesh& mesh) {
    EXPECT_FALSE(oracle::open_edge(mesh));
    EXPECT_TRUE(oracle::self_intersections(mesh).empty());
}

TEST(OracleSolid, EveryFamilyAsItsRecipe) {
    scenes::Random random(1);
    scenes::for_each_case(scenes::solid_families(), random, 8, [](const scenes::SolidCase& made) {
        expect_solid(*made.a.mesh);
        expect_solid(*made.b.mesh);
        const Relation relation = solid_relation(made.a, made.b);
        EXPECT_EQ(solid_relation(made.b, made.a), mirrored(relation));
        EXPECT_EQ(relation, made.relation.value_or(relation));
        for (const auto& [point, side] : made.points) {
            EXPECT_EQ(static_cast<Side>(oracle::locate(point, soup(made.a)).side), side) << point.transpose();
        }
    });
}

TEST(OracleSolid, EveryContactAsSaid) {
    scenes::Random random(2);
    for (const scenes::LatticePair& pair : scenes::fixed_contacts()) {
        const scenes::PosedMesh a = scenes::place(pair.a, {}, 0, random), b = scenes::place(pair.b, {}, 0, random);
        expect_solid(*a.mesh);
        expect_solid(*b.mesh);
        EXPECT_EQ(solid_relation(a, b), pair.relation) << pair.name;
        EXPECT_EQ(solid_relation(b, a), mirrored(pair.relation)) << pair.name;
    }
}

// A surface that is part of a cube's, or that leaves the cube where nothing but a segment of it is inside.
TEST(OracleSolid, SurfacesAndASolid) {
    const auto cube = scenes::cube(1);
    const auto is = [&](const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
        return oracle::surface_relation({vertices, triangles, Pose()}, {cube->vertices(), cube->triangles(), Pose()});
    };
    using enum Relation;
    EXPECT_EQ(is({{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}, {{0, 1, 2}}), apart);
    EXPECT_EQ(is({{1, 0, 0}, {3, 0, 0}, {2, 1, 0}}, {{0, 1, 2}}), touching);
    EXPECT_EQ(is({{1, 0, 0}, {1, 0.5, 0}, {1, 0, 0.5}}, {{0, 1, 2}}), touching);
    EXPECT_EQ(is({{1, 0, 0}, {1, 5, 0}, {1, 0, 5}}, {{0, 1, 2}}), touching);
    EXPECT_EQ(is({{1, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}, {{0, 1, 2}}), inside);
    EXPECT_EQ(is({{1, 1, 1}, {-1, -1, -1}, {0, 0, 0}}, {{0, 1, 2}}), inside);
    EXPECT_EQ(is({{1, 1, 1}, {-1, 1, 1}, {0, 1, 1}}, {{0, 1, 2}}), touching);
    EXPECT_EQ(is({{1, 1, 1}, {-2, -2, -2}, {0, 0, 0}}, {{0, 1, 2}}), crossing);
    EXPECT_EQ(is({{0, 0, 0}}, {{0, 0, 0}}), inside);
    EXPECT_EQ(is({{0, 1, 0}}, {{0, 0, 0}}), touching);
    EXPECT_EQ(is({{0, 1, 0}, {3, 3, 3}}, {{0, 0, 0}, {1, 1, 1}}), touching);
    EXPECT_EQ(is({{0, 0.5, 0}, {3, 3, 3}}, {{0, 0, 0}, {1, 1, 1}}), crossing);
}

TEST(OracleSolid, WhatIsNotClosedIsNamed) {
    const auto open = [](const std::vector<Triangle>& triangles) {
        std::vector<Vec3> vertices{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}};
        return oracle::open_edge(*Mesh::create(std::move(vertices), triangles));
    };
    using Name = oracle::CornerEdge;
    EXPECT_FALSE(open({{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}));
    EXPECT_EQ(open({{0, 1, 2}, {0, 1, 3}, {0, 2, 3}}), (Name{0, 1}));
    EXPECT_FALSE(open({{0, 4, 2}, {4, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}));
    EXPECT_FALSE(open({{0, 4, 2}, {4, 1, 2}, {0, 1, 4}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}));
    // Of the long edge the other half is uncovered: it is where that begins that ends are odd, of the first half, too.
    EXPECT_EQ(open({{0, 4, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}), (Name{0, 0}));
    EXPECT_EQ(open({{0, 1, 2}, {0, 1, 2}, {0, 1, 3}}), (Name{0, 0}));
}

TEST(OracleSolid, SelfIntersectionsAreNamed) {
    const auto pairs = [](const std::vector<Vec3>& vertices) {
        return oracle::self_intersections(*Mesh::create(vertices, {{0, 1, 2}, {3, 4, 5}}));
    };
    const std::vector<TrianglePair> wrong{{0, 1}}, none;
    const Vec3 p(0, 0, 0), q(4, 0, 0), r(0, 4, 0);
    EXPECT_EQ(pairs({p, q, r, {1, 1, -1}, {1, 1, 1}, {9, 9, 0}}), wrong);  // through each other
    EXPECT_EQ(pairs({p, q, r, {1, 1, 0}, {2, 1, 0}, {1, 1, 5}}), wrong);   // a side in a face
    EXPECT_EQ(pairs({p, q, r, {1, 1, 0}, {9, 9, 1}, {9, 9, 3}}), none);    // a corner on a face
    EXPECT_EQ(pairs({p, q, r, {1, 0, 0}, {2, 0, 0}, {1, 1, 5}}), none);    // a side on a side
    EXPECT_EQ(pairs({p, q, r, {1, 0, 0}, {2, 0, 0}, {1, -1, 0}}), none);   // the same, in one plane
    EXPECT_EQ(pairs({p, q, r, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}), wrong);   // folded over it
    EXPECT_EQ(pairs({p, q, r, r, p, q}), wrong);                           // twice
    EXPECT_EQ(pairs({p, q, r, q, p, {2, -3, 0}}), none);
    EXPECT_EQ(pairs({p, q, r, {4, 4, 0}, {1, 1, 0}, {2, 1, 5}}), wrong);     // a side from outside into the face
    EXPECT_EQ(pairs({p, q, r, {1, 1, -1}, {1, 1, -5}, {1, 1, 5}}), none);    // zero area
    EXPECT_EQ(pairs({p, q, r, {-1, 1, 0}, {-1, -1, 5}, {-1, 1, 5}}), none);  // apart
    EXPECT_EQ(pairs({p, q, r, {2, 0, 0}, {2, -1, 1}, {2, -1, -1}}), none);   // a corner on a side
}

TEST(OracleSolid, FeaturesAreNamed) {
    const auto cube = scenes::cube(1);
    const auto at = [&](double x, double y, double z) {
        return oracle::locate({x, y, z}, {cube->vertices(), cube->triangles(), Pose()});
    };
    EXPECT_EQ(at(0, 0, 0).side, oracle::PointSide::inside);
    EXPECT_EQ(at(0, 0, 1 + 0x1p-52).side, oracle::PointSide::outside);
    EXPECT_EQ(at(0, 0, 1).side, oracle::PointSide::on);
    EXPECT_EQ(at(1, 1, 1).feature.dimension, 0);
    EXPECT_EQ(at(1, 1, 0.5).feature.dimension, 1);
    EXPECT_EQ(at(1, 0.5, 0.25).feature.dimension, 2);
}

}  // namespace
}  // namespace ecods::oracle_solid_test
