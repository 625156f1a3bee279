// Polygons, segments and points as convex solids: questions of which the answers are known.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "scenes/pose_at.hpp"
#include "unit/query/flat_sets.hpp"

namespace ecods {
namespace {

using namespace flat_sets;

TEST(FlatQuestions, DistanceAndNamesAreOfTheSet) {
    // Two cuts of one square: a point over its middle is over a diagonal, and over a vertex.
    const std::vector<Vec3> vertices{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}};
    const SolidPtr over = point({0, 0, 2});
    for (const auto& triangles : {std::vector<Triangle>{{0, 1, 2}, {2, 3, 0}},
                                  std::vector<Triangle>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}) {
        const SolidPtr plate = solid_of(vertices, triangles);
        const ClosestPoints found = closest({plate, Pose()}, {over, Pose()});
        EXPECT_EQ(found.distance, 2);
        EXPECT_EQ(found.kind, ClosestKind::vertex_face);
        EXPECT_EQ(found.a, (Feature{Feature::Kind::face, 0, 0}));
        EXPECT_EQ(found.b, (Feature{Feature::Kind::vertex, 0, 0}));
        EXPECT_EQ(found.point_a, Vec3(0, 0, 0));
        EXPECT_TRUE(within({plate, Pose()}, {over, Pose()}, 2));
        EXPECT_FALSE(within({plate, Pose()}, {over, Pose()}, std::nextafter(2, 0)));
    }
    // Segments: parallel, skew, and in a row.
    const SolidPtr x = segment({-1, 0, 0}, {1, 0, 0}), y = segment({0, -1, 0}, {0, 1, 0});
    EXPECT_EQ(closest({x, Pose()}, {y, at(0, 0, 3)}).kind, ClosestKind::edge_edge);
    EXPECT_EQ(closest({x, Pose()}, {x, at(0, 3, 4)}).distance, 5);
    EXPECT_EQ(closest({x, Pose()}, {x, at(5, 0, 0)}).distance, 3);
    EXPECT_EQ(closest({x, Pose()}, {x, at(0.5, 3, 4)}).kind, ClosestKind::vertex_edge);
    EXPECT_EQ(distance({square(1), at(0, 0, 1)}, {square(2), at(0, 0, 1)}), 0);
    EXPECT_EQ(distance({square(1), at(0, 0, 1)}, {square(2), at(3.5, 0, 1)}), 0.5);
}

TEST(FlatQuestions, RelationsToSolids) {
    const SolidPtr plate = square(1), rod = segment({0, 0, -1}, {0, 0, 1}), dot = point({0, 0, 0});
    const SolidPtr whole = cube(3);
    const auto general = std::make_shared<const Solid>(whole->mesh_ptr());
    for (const std::shared_ptr<const Solid>& solid : {std::shared_ptr<const Solid>(whole), general}) {
        for (const SolidPtr& flat : {plate, rod, dot}) {
            expect_relation(Relation::inside, {flat, Pose()}, {solid, Pose()});
            expect_relation(Relation::apart, {flat, at(9, 0, 0)}, {solid, Pose()});
        }
        expect_relation(Relation::touching, {plate, at(0, 0, 3)}, {solid, Pose()});  // in a face
        expect_relation(Relation::inside, {rod, at(0, 0, 2)}, {solid, Pose()});      // ends in a face
        expect_relation(Relation::crossing, {rod, at(0, 0, 3)}, {solid, Pose()});
        expect_relation(Relation::crossing, {plate, at(3, 0, 0)}, {solid, Pose()});
        expect_relation(Relation::touching, {plate, at(4, 0, 0)}, {solid, Pose()});
        expect_relation(Relation::touching, {dot, at(3, 3, 3)}, {solid, Pose()});
        EXPECT_EQ(distance({plate, Pose()}, {solid, Pose()}), 0);
        EXPECT_EQ(closest({rod, Pose()}, {solid, Pose()}).kind, ClosestKind::contained);
        EXPECT_EQ(cast({rod, Pose()}, Vec3(9, 0, 0), {solid, Pose()})->kind, ClosestKind::contained);
        EXPECT_EQ(cast({rod, at(-9, 0, 0)}, Vec3(12, 0, 0), {solid, Pose()})->time, 0.5);
    }
}

TEST(FlatQuestions, RelationsToFlatSetsAndSurfaces) {
    const SolidPtr plate = square(2), rod = segment({0, 0, -1}, {0, 0, 1}), dot = point({0, 0, 0});
    Pose upright;
    upright.R << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // in the plane x = 0
    // Through the diagonal of a cut, where triangles touch only.
    expect_relation(Relation::crossing, {rod, Pose()}, {plate, Pose()});
    expect_relation(Relation::crossing, {rod, at(0.5, 0.5)}, {plate, Pose()});
    expect_relation(Relation::crossing, {rod, at(0.5, 0.25)}, {plate, Pose()});
    expect_relation(Relation::touching, {rod, at(2, 0)}, {plate, Pose()});
    expect_relation(Relation::touching, {rod, at(2, 2)}, {plate, Pose()});
    expect_relation(Relation::touching, {rod, at(0, 0, 1)}, {plate, Pose()});
    expect_relation(Relation::touching, {dot, Pose()}, {plate, Pose()});
    expect_relation(Relation::touching, {plate, Pose()}, {plate, Pose()});
    expect_relation(Relation::touching, {plate, Pose()}, {square(1), Pose()});
    expect_relation(Relation::touching, {rod, Pose()}, {rod, Pose()});
    expect_relation(Relation::touching, {rod, Pose()}, {segment({-1, 0, 0}, {1, 0, 0}), Pose()});
    expect_relation(Relation::crossing, {plate, Pose()}, {plate, upright});
    expect_relation(Relation::apart, {plate, at(0, 0, 1)}, {dot, Pose()});
    upright.t = {0, 4, 0};
    expect_relation(Relation::touching, {plate, Pose()}, {plate, upright});  // end to end on the line of both planes
    upright.t = {0, 3.5, 0};
    expect_relation(Relation::crossing, {plate, Pose()}, {plate, upright});
    upright.t = {2, 0, 0};
    expect_relation(Relation::touching, {plate, Pose()}, {plate, upright});
    // A plane through the diagonal: each triangle of one ends there.
    const SolidPtr diagonal = hull_of({{-1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, -1, 1}});
    const SolidPtr other = solid_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
    expect_relation(Relation::crossing, {diagonal, Pose()}, {other, Pose()});
    // Surfaces: a triangle, and a segment that is three points in a row.
    const MeshShape wall(Mesh::create({{-1, -1, -1}, {1, 1, -1}, {1, 1, 1}}, {{0, 1, 2}}));
    expect_relation(Relation::crossing, {wall, Pose()}, {other, Pose()});
    const MeshShape wire(Mesh::create({{0, 0, -1}, {0, 0, 0}, {0, 0, 1}}, {{1, 0, 2}}));
    expect_relation(Relation::crossing, {wire, Pose()}, {other, Pose()});
    expect_relation(Relation::touching, {wire, at(1, 0)}, {other, Pose()});
}

TEST(FlatQuestions, DepthIsWhatPartsByAPlane) {
    const SolidPtr plate = square(2), rod = segment({0, 0, -1}, {0, 0, 1}), dot = point({0, 0, 0});
    // A rod through a plate leaves it along itself.
    const Depth through = depth({plate, Pose()}, {rod, at(0.5, 0, 0.25)}).value();
    EXPECT_EQ(through.depth, 0.75);
    EXPECT_EQ(through.direction, Vec3(0, 0, 1));
    EXPECT_EQ(through.a.kind, Feature::Kind::face);
    EXPECT_EQ(through.b.kind, Feature::Kind::vertex);
    EXPECT_EQ(depth({plate, Pose()}, {rod, at(0.5, 0, -0.25)})->direction, Vec3(0, 0, -1));
    // At its middle both ways tie: the vertex that is named first.
    EXPECT_EQ(depth({plate, Pose()}, {rod, Pose()})->depth, 1);
    EXPECT_EQ(depth({plate, Pose()}, {rod, Pose()})->direction, Vec3(0, 0, 1));
    // Near a side the way out is across: a product of edges.
    const Depth beside = depth({plate, Pose()}, {rod, at(1.75, 0, 0)}).value();
    EXPECT_EQ(beside.depth, 0.25);
    EXPECT_EQ(beside.direction, Vec3(1, 0, 0));
    EXPECT_EQ(beside.a.kind, Feature::Kind::edge);
    EXPECT_EQ(beside.b.kind, Feature::Kind::edge);
    // A point in a solid, and a plate in it.
    EXPECT_EQ(depth({cube(3), Pose()}, {dot, at(2, 0, 0.5)})->depth, 1);
    EXPECT_EQ(depth({cube(3), Pose()}, {dot, at(2, 0, 0.5)})->direction, Vec3(1, 0, 0));
    EXPECT_EQ(depth({cube(3), Pose()}, {plate, at(0, 0, 0.5)})->depth, 2.5);
    EXPECT_EQ(depth({plate, at(0, 0, 0.5)}, {cube(3), Pose()})->direction, Vec3(0, 0, -1));
    // A rod so short that doubles take all differences for a plane.
    const SolidPtr tiny = segment({0, 0, -0x1p-300}, {0, 0, 0x1p-299});
    EXPECT_EQ(depth({plate, Pose()}, {tiny, Pose()})->depth, 0x1p-300);
    EXPECT_EQ(depth({plate, Pose()}, {tiny, Pose()})->direction, Vec3(0, 0, 1));
    EXPECT_EQ(depth({tiny, Pose()}, {plate, Pose()})->direction, Vec3(0, 0, -1));
    // Rods along the edges of a wedge as thin.
    const SolidPtr wedge = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0x1p-300}});
    for (const auto& [p, q] : {std::pair(Vec3(-1, 0.25, 0), Vec3(1, 0.25, 0)), {Vec3(0.25, -1, 0), Vec3(0.25, 1, 0)}}) {
        const Depth thin = depth({segment(p, q), at(0, 0, 0x1p-302)}, {wedge, Pose()}).value();
        EXPECT_EQ(thin.depth, 0x1p-302);
        EXPECT_EQ(thin.direction, Vec3(0, 0, 1));
        EXPECT_EQ(thin.b.kind, Feature::Kind::face);
    }
    EXPECT_FALSE(depth({plate, Pose()}, {dot, at(0, 0, 1)}));
    EXPECT_EQ(depth({cube(3), Pose()}, {dot, at(3, 0, 0)})->depth, 0);
}

// The depth of sets in one plane is 0, along its normal.
TEST(FlatQuestions, DepthInOnePlane) {
    const SolidPtr plate = square(2), dot = point({0, 0, 0});
    const SolidPtr x = segment({-1, 0, 0}, {1, 0, 0}), y = segment({0, -1, 0}, {0, 1, 0});
    const auto expect = [](const SolidPtr& a, const Pose& at_a, const SolidPtr& b, const Pose& at_b,
                           const Vec3& direction) {
        const SignedDistance found = signed_distance({a, at_a}, {b, at_b});
        EXPECT_EQ(found.distance, 0);
        EXPECT_FALSE(std::signbit(found.distance));
        EXPECT_EQ(found.direction, direction);
        EXPECT_EQ(found.point_a, found.point_b);
        const Depth deep = depth({a, at_a}, {b, at_b}).value();
        EXPECT_EQ(deep.depth, 0);
        EXPECT_EQ(deep.direction, direction);
        const DepthBounds bounds = depth_bounds({a, at_a}, {b, at_b}).value();
        EXPECT_EQ(bounds.lower, 0);
        EXPECT_EQ(bounds.upper, 0);
        EXPECT_EQ(bounds.parted, at_b.t);
    };
    expect(plate, Pose(), plate, at(1, 1), {0, 0, 1});
    expect(plate, Pose(), x, Pose(), {0, 0, 1});
    expect(x, Pose(), plate, Pose(), {0, 0, 1});
    expect(dot, Pose(), plate, Pose(), {0, 0, 1});
    expect(x, Pose(), y, Pose(), {0, 0, 1});
    expect(y, Pose(), x, Pose(), {0, 0, -1});
    expect(x, Pose(), x, at(1.5), {0, 0, 1});  // across both, the product with the y axis
    expect(dot, Pose(), dot, Pose(), {1, 0, 0});
    Pose turned;
    turned.R << 1, 0, 0, 0, -1, 0, 0, 0, -1;
    expect(plate, turned, dot, Pose(), {0, 0, -1});
    // Ends that differ by less than rounding shows.
    const SolidPtr left = segment({0, 0, 0}, {1, 0, 0}), right = segment({1 - 0x1p-53, 0, 0}, {2, 0, 0});
    EXPECT_EQ(signed_distance({left, Pose()}, {right, Pose()}).kind, ClosestKind::vertex_edge);
    EXPECT_EQ(signed_distance({left, Pose()}, {right, at(0x1p-53)}).kind, ClosestKind::vertex_vertex);
    EXPECT_FALSE(depth({x, Pose()}, {x, at(2.5)}));
    EXPECT_FALSE(depth({plate, Pose()}, {plate, at(4.5)}));
    EXPECT_EQ(signed_distance({plate, Pose()}, {plate, at(4.5)}).distance, 0.5);
    EXPECT_EQ(signed_distance({dot, Pose()}, {dot, at(0, 3, 4)}).direction, Vec3(0, 0.6, 0.8));
}

TEST(FlatQuestions, DepthBounds) {
    const SolidPtr plate = square(2), rod = segment({0, 0, -1}, {0, 0, 1});
    const DepthBounds bounds = depth_bounds({plate, Pose()}, {rod, at(0.5, 0, 0.25)}).value();
    EXPECT_LE(bounds.lower, 0.75);
    EXPECT_GE(bounds.lower, 0.75 * (1 - 0x1p-50));
    EXPECT_GE(bounds.upper, 0.75);
    EXPECT_LE(bounds.upper, 0.75 * (1 + 0x1p-40));
    EXPECT_EQ(depth({plate, Pose()}, {rod, at(bounds.parted)}).value_or(Depth()).depth, 0);
    // Of a solid that is not convex no inner points meet.
    Soup notched = soup_of_box({-3, -3, -3}, {3, 3, 3});
    notched.add_box({4, 4, 4}, {5, 5, 5});
    const Solid two(notched.mesh());
    EXPECT_EQ(depth_bounds({plate, Pose()}, {two, Pose()})->upper, 0);
    EXPECT_FALSE(depth_bounds({two, Pose()}, {plate, at(9, 9, 9)}));
    const DistanceBounds inside = signed_distance_bounds({plate, Pose()}, {two, Pose()});
    EXPECT_EQ(inside.lower, 0);
    EXPECT_EQ(inside.upper, 0);
    EXPECT_EQ(signed_distance_bounds({plate, Pose()}, {cube(3), Pose()}).lower, -3);
}

TEST(FlatQuestions, PointsLinesAndHits) {
    const SolidPtr plate = square(2), rod = segment({0, 0, -1}, {0, 0, 1}), dot = point({1, 2, 3});
    EXPECT_EQ(locate({1, 0.5, 0}, {plate, Pose()}).side, Side::on);
    EXPECT_EQ(locate({1, 0.5, 0}, {plate, Pose()}).feature.kind, Feature::Kind::face);
    EXPECT_EQ(locate({1, 0.5, 0.5}, {plate, Pose()}).side, Side::outside);
    EXPECT_EQ(locate({0, 0, 0.5}, {rod, Pose()}), (Location{Side::on, {Feature::Kind::edge, 0, 0}}));
    EXPECT_EQ(locate({0, 0, 1}, {rod, Pose()}), (Location{Side::on, {Feature::Kind::vertex, 0, 1}}));
    EXPECT_EQ(locate({0, 0, 2}, {rod, Pose()}).side, Side::outside);
    EXPECT_EQ(locate({1, 2, 3}, {dot, Pose()}), (Location{Side::on, {Feature::Kind::vertex, 0, 0}}));
    EXPECT_EQ(signed_distance(Vec3(1, 1, 3), Posed<MeshShape>(plate, Pose())), 3);
    EXPECT_EQ(signed_distance(Vec3(1, 1, 0), Posed<MeshShape>(plate, Pose())), 0);
    EXPECT_EQ(signed_distance(Vec3(3, 0, 5), Posed<MeshShape>(rod, Pose())), 5);
    EXPECT_EQ(closest(Vec3(3, 0, 0.5), Posed<MeshShape>(rod, Pose())).point, Vec3(0, 0, 0.5));
    EXPECT_EQ(closest(Vec3(1, 1, -3), Posed<MeshShape>(plate, Pose())).distance, 3);
    const Segment down{{1, 0.5, 3}, {1, 0.5, -1}};
    EXPECT_EQ(first_hit(down, {plate, Pose()})->parameter, 0.75);
    EXPECT_EQ(first_hit(down, {plate, Pose()})->kind, HitKind::front);
    EXPECT_EQ(all_hits(Segment{{1, 0.5, 0}, {1, 0.5, -1}}, {plate, Pose()}).size(), 1U);
    EXPECT_EQ(first_hit(Segment{{0, 0, 3}, {0, 0, -3}}, {rod, Pose()})->kind, HitKind::along);
    EXPECT_FALSE(first_hit(Segment{{1, 0, 3}, {1, 0, -3}}, {rod, Pose()}));
    EXPECT_EQ(cast({rod, at(0, 0, 5)}, Vec3(0, 0, -8), {plate, Pose()})->time, 0.5);
}

TEST(FlatQuestions, HalfSpaces) {
    const HalfSpace ground({0, 0, 2}, 0);
    const Posed<HalfSpace> below(ground, Pose());
    const SolidPtr plate = square(2), rod = segment({0, 0, -1}, {0, 0, 1}), dot = point({0, 0, 0});
    const auto of = [](const SolidPtr& solid, const Vec3& t) { return Posed<MeshShape>(solid, at(t)); };
    EXPECT_EQ(relation(of(rod, {0, 0, 0}), below), Relation::crossing);
    EXPECT_EQ(relation(of(rod, {0, 0, 1}), below), Relation::touching);
    EXPECT_EQ(relation(of(rod, {0, 0, -1}), below), Relation::inside);
    EXPECT_EQ(relation(of(plate, {0, 0, 0}), below), Relation::touching);
    EXPECT_EQ(relation(of(plate, {0, 0, -1}), below), Relation::inside);
    EXPECT_EQ(relation(of(plate, {0, 0, 1}), below), Relation::apart);
    EXPECT_EQ(relation(of(dot, {0, 0, 0}), below), Relation::touching);
    EXPECT_EQ(signed_distance(of(rod, {0, 0, 0.25}), below).distance, -0.75);
    EXPECT_EQ(signed_distance(of(plate, {0, 0, 3}), below).distance, 3);
    EXPECT_EQ(cast(of(plate, {0, 0, 3}), Vec3(0, 0, -6), below)->time, 0.5);
}

TEST(FlatQuestions, RoundedCores) {
    const SolidPtr plate = square(2);
    const SolidPtr dot = point({0, 0, 0});
    const Rounded slab(plate, 0.5), ball(dot, 1), small(dot, 0.5);
    EXPECT_EQ(distance(Posed<Rounded>(slab, Pose()), Posed<Rounded>(ball, at(0, 0, 2))), 0.5);
    EXPECT_EQ(relation(Posed<Rounded>(slab, Pose()), Posed<Rounded>(ball, at(0, 0, 1.5))), Relation::touching);
    EXPECT_EQ(relation(Posed<Rounded>(slab, Pose()), Posed<Rounded>(ball, at(0, 0, 1))), Relation::overlapping);
    EXPECT_EQ(relation(Posed<Rounded>(slab, Pose()), Posed<MeshShape>(plate, Pose())), Relation::contains);
    EXPECT_EQ(relation(Posed<Rounded>(ball, Pose()), Posed<MeshShape>(cube(3), Pose())), Relation::inside);
    EXPECT_EQ(relation(Posed<Rounded>(ball, at(0.5)), Posed<Rounded>(slab, Pose())), Relation::overlapping);
    EXPECT_EQ(relation(Posed<Rounded>(small, Pose()), Posed<Rounded>(slab, Pose())), Relation::inside);
    EXPECT_EQ(relation(Posed<Rounded>(ball, Pose()), Posed<MeshShape>(plate, Pose())), Relation::crossing);
}

}  // namespace
}  // namespace ecods
