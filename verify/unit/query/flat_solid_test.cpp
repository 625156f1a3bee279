// Polygons, segments and points as convex solids: how they are made, at singular poses and in a World.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <tuple>
#include <utility>
#include <vector>

#include "ecods/builders.hpp"
#include "ecods/certificate.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "ecods/trace.hpp"
#include "ecods/world.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/pose_at.hpp"
#include "unit/query/flat_sets.hpp"

namespace ecods {
namespace {

using namespace flat_sets;

TEST(FlatSolid, HullsOfPointsInOnePlane) {
    const SolidPtr one = hull_of({{1, 2, 3}, {1, 2, 3}});
    EXPECT_EQ(one->dimension(), 0);
    EXPECT_EQ(triangles_of(one), (std::vector<Triangle>{{0, 0, 0}}));
    const SolidPtr line = hull_of({{1, 1, 1}, {3, 3, 3}, {0, 0, 0}, {5, 5, 5}, {2, 2, 2}});
    EXPECT_EQ(line->dimension(), 1);
    EXPECT_EQ(triangles_of(line), (std::vector<Triangle>{{0, 1, 1}}));
    EXPECT_EQ(line->mesh().vertices()[0], Vec3(0, 0, 0));
    EXPECT_EQ(line->mesh().vertices()[1], Vec3(5, 5, 5));
    // Points inside, on sides, and twice; the polygon looks up.
    const SolidPtr plane = hull_of({{1, 1, 0}, {0, 2, 0}, {0, 0, 0}, {2, 2, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}});
    EXPECT_EQ(plane->dimension(), 2);
    EXPECT_EQ(triangles_of(plane), (std::vector<Triangle>{{0, 1, 3}, {0, 3, 2}}));
    EXPECT_EQ(plane->mesh().vertices()[0], Vec3(0, 2, 0));
    EXPECT_EQ(cube(1)->dimension(), 3);
    EXPECT_INVALID(hull_of({}), NotSolid::Reason::no_interior);
    // A hull's mesh is its own hull.
    for (const SolidPtr& solid : {one, line, plane}) {
        const auto same = std::make_shared<const ConvexSolid>(solid->mesh_ptr());
        EXPECT_EQ(triangles_of(same), triangles_of(solid));
        EXPECT_EQ(same->dimension(), solid->dimension());
    }
}

// One double beside a plane.
TEST(FlatSolid, IsFlatExactly) {
    std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.3, 0}};
    EXPECT_EQ(hull_of(points)->dimension(), 2);
    points[3].z() = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(hull_of(points)->dimension(), 3);
    points = {{0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}};
    EXPECT_EQ(hull_of(points)->dimension(), 1);
    points[1].x() = std::nextafter(0.2, 1);
    EXPECT_EQ(hull_of(points)->dimension(), 2);
}

TEST(FlatSolid, MeshesThatCoverAFlatSet) {
    const std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {1, 0, 0}, {9, 9, 9}};
    const auto dimension = [&](std::vector<Triangle> triangles) {
        return solid_of(square, std::move(triangles))->dimension();
    };
    EXPECT_EQ(dimension({{0, 1, 2}}), 2);
    EXPECT_EQ(dimension({{2, 1, 0}}), 2);                                              // the other way around
    EXPECT_EQ(dimension({{1, 2, 3}, {3, 0, 1}}), 2);                                   // the other diagonal
    EXPECT_EQ(dimension({{0, 1, 2}, {3, 2, 0}}), 2);                                   // turned both ways
    EXPECT_EQ(dimension({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}), 2);             // a vertex inside
    EXPECT_EQ(dimension({{0, 5, 4}, {5, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}), 2);  // and on a side
    EXPECT_EQ(dimension({{0, 1, 2}, {0, 2, 3}, {0, 4, 2}, {1, 6, 6}, {5, 5, 5}}), 2);  // some have no area
    EXPECT_EQ(dimension({{0, 5, 1}, {1, 1, 1}}), 1);
    EXPECT_EQ(dimension({{0, 4, 0}, {4, 2, 2}, {4, 4, 4}}), 1);  // pieces
    EXPECT_EQ(dimension({{6, 6, 6}, {6, 6, 6}}), 0);
    using Reason = NotSolid::Reason;
    const auto refused = [&](std::vector<Triangle> triangles) { return solid_of(square, std::move(triangles)); };
    EXPECT_INVALID(refused({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}}), Reason::open_edge);  // a notch
    EXPECT_INVALID(refused({{0, 1, 4}, {2, 3, 4}}), Reason::open_edge);             // two parts
    EXPECT_INVALID(refused({{0, 1, 2}, {0, 2, 3}, {1, 2, 3}}), Reason::open_edge);  // twice
    EXPECT_INVALID(refused({{0, 1, 2}, {0, 1, 2}}), Reason::self_intersection);
    EXPECT_INVALID(refused({{0, 5, 4}, {1, 4, 0}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}), Reason::open_edge);
    EXPECT_INVALID(refused({{0, 5, 3}, {5, 1, 2}, {5, 2, 4}, {4, 2, 3}, {3, 5, 4}, {0, 1, 4}}), Reason::open_edge);
    EXPECT_INVALID(refused({{0, 0, 5}, {2, 2, 3}}), Reason::no_interior);         // no hull
    EXPECT_INVALID(refused({{0, 0, 0}, {1, 1, 1}}), Reason::no_interior);         // two points
    EXPECT_INVALID(refused({{0, 5, 0}, {1, 1, 1}}), Reason::no_interior);         // a gap
    EXPECT_INVALID(Solid(Mesh::create(square, {{0, 1, 2}})), Reason::open_edge);  // no solid
    EXPECT_INVALID(Solid(Mesh::create(square, {{0, 1, 1}})), Reason::no_interior);
    // A triangle in the middle, there twice; a hole.
    const std::vector<Vec3> wide{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    const std::vector<Triangle> around{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    const auto with = [&](std::vector<Triangle> middle) {
        middle.insert(middle.end(), around.begin(), around.end());
        return solid_of(wide, std::move(middle));
    };
    EXPECT_EQ(with({{3, 4, 5}})->dimension(), 2);
    EXPECT_INVALID(with({{3, 4, 5}, {3, 4, 5}}), Reason::open_edge);
    EXPECT_INVALID(with({}), Reason::open_edge);
    const std::vector<Vec3> frame{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                                  {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
    EXPECT_INVALID(
        solid_of(frame, {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}}),
        Reason::open_edge);
    // Copies of vertices are the same vertices.
    Soup soup;
    soup.add({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    EXPECT_EQ(ConvexSolid(soup.mesh()).dimension(), 2);
}

// Zero-area triangles are no parts of a polygon.
TEST(FlatSolid, TrianglesWithoutAreaDoNotCount) {
    const SolidPtr plate = solid_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {9, 9, 9}},
                                    {{0, 4, 4}, {0, 1, 2}, {0, 2, 3}, {4, 4, 4}});
    EXPECT_EQ(distance({plate, Pose()}, {point({9, 9, 9}), Pose()}),
              distance({square(1), Pose()}, {point({9, 9, 9}), Pose()}));
    EXPECT_EQ(locate({9, 9, 9}, {plate, Pose()}).side, Side::outside);
    expect_relation(Relation::inside, {plate, Pose()}, {cube(3), Pose()});
    EXPECT_EQ(relation(Posed<MeshShape>(plate, Pose()), {std::make_shared<const HalfSpace>(Vec3(0, 0, 1), 1), Pose()}),
              Relation::inside);
    EXPECT_EQ(closest({plate, Pose()}, {point({0, 0, 1}), Pose()}).a, (Feature{Feature::Kind::face, 1, 0}));
    Pose singular;
    singular.R(2, 2) = 0;
    EXPECT_EQ(locate({9, 9, 0}, {plate, singular}).side, Side::outside);
    EXPECT_EQ(locate({0, 0, 0}, {plate, singular}).side, Side::on);
}

TEST(FlatSolid, SingularPosesAndWhatIsRefused) {
    const SolidPtr plate = square(2), rod = segment({0, 0, -1}, {0, 0, 1});
    Pose thin;
    thin.R(1, 1) = 0;  // the plate becomes a segment, from x = -2 to 2
    expect_relation(Relation::touching, {rod, Pose()}, {plate, thin});
    expect_relation(Relation::inside, {plate, thin}, {cube(3), Pose()});
    EXPECT_EQ(distance({plate, thin}, {rod, at(0, 3, 0)}), 3);
    EXPECT_EQ(closest({plate, thin}, {rod, at(5, 0, 0)}).distance, 3);
    EXPECT_EQ(locate({1, 0, 0}, {plate, thin}).side, Side::on);
    EXPECT_EQ(locate({1, 1, 0}, {plate, thin}).side, Side::outside);
    EXPECT_THROW(std::ignore = depth({plate, thin}, {rod, Pose()}), SingularPose);
    EXPECT_THROW(std::ignore = signed_distance({plate, Pose()}, {rod, thin}), SingularPose);
    EXPECT_THROW(std::ignore = depth_bounds({plate, thin}, {rod, Pose()}), SingularPose);
    EXPECT_THROW(std::ignore = certify(Posed<MeshShape>(plate, Pose()), Posed<MeshShape>(rod, Pose())), NotSupported);
    EXPECT_EQ(certify({surface_of(*plate), Pose()}, {surface_of(*rod), Pose()}).claim(),
              Certificate::Claim::touching);  // by triangles, which touch at the cut between them
    EXPECT_INVALID(prism(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}}, 1), NotSolid::Reason::no_interior);
}

TEST(FlatSolid, ListsOfAWorld) {
    std::stringstream trace;
    World world;
    world.trace_to(trace);
    const SolidPtr plate = square(2);
    const SolidPtr rod = segment({0, 0, -1}, {0, 0, 1}), solid = cube(3);
    world.set_relations(true);
    const BodyId a = world.create_body(plate, Pose()), b = world.create_body(rod, at(0.5, 0, 0.25)),
                 c = world.create_body(solid, at(9));
    world.update();
    EXPECT_EQ(std::vector(world.relations().begin(), world.relations().end()),
              (std::vector<PairRelation>{{{a, b}, Relation::crossing}}));
    EXPECT_EQ(world.depths(),
              (std::vector<BodyDepth>{{{a, b}, depth({plate, Pose()}, {rod, at(0.5, 0, 0.25)}).value()}}));
    EXPECT_EQ(world.signed_distances(4), (std::vector<PairDistance>{{{a, b}, -0.75}, {{a, c}, 4}}));
    world.set_pose(c, Pose());
    world.update();
    EXPECT_EQ(std::vector(world.relations().begin(), world.relations().end()),
              (std::vector<PairRelation>{
                  {{a, b}, Relation::crossing}, {{a, c}, Relation::inside}, {{b, c}, Relation::inside}}));
    EXPECT_EQ(world.depth(a, b)->depth, 0.75);
    EXPECT_EQ(world.bodies_containing({0, 0, 0}).bodies, (std::vector<BodyAt>{{a, Side::on}, {c, Side::inside}}));
    world.check_invariants();
    // A trace makes the same bodies.
    world.end_trace();
    const ReplayReport report = replay(trace, {.checks_invariants = true});
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.colliding_count, 3U);
}

}  // namespace
}  // namespace ecods
