// Points and normals of first contacts: known answers.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

ContactPoint point_of(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                      std::optional<ClosestKind> kind = {}) {
    const auto contact = cast(a, motion, b);
    EXPECT_TRUE(contact);
    if (!contact) return {};
    EXPECT_EQ(contact->kind, kind.value_or(contact->kind));
    const ContactPoint found = contact_point(a, motion, b, *contact);
    // The other body moves against it: the same point, relative to b, and the opposite normal.
    const auto turned = cast(b, -motion, a);
    EXPECT_TRUE(turned && turned->time == contact->time);
    return found;
}

TEST(ContactPoint, OfACubeThatLandsFlat) {
    const Solid cube(box({0, 0, 0}, {1, 1, 1})), floor(box({-8, -8, -1}, {8, 8, 0}));
    const MeshShape cube_surface(cube.mesh_ptr()), floor_surface(floor.mesh_ptr());
    for (const Vec3& motion : {Vec3(0, 0, -1), Vec3(3, 0, -1), Vec3(-5, 7, -1), Vec3(0.25, 0.125, -1)}) {
        for (const bool is_solid : {false, true}) {
            const Posed<MeshShape> a{is_solid ? cube : cube_surface, at({0.25, 0.5, 0.5})},
                b{is_solid ? floor : floor_surface, Pose()};
            const ContactPoint found = point_of(a, motion, b);
            EXPECT_EQ(found.point[2], 0);
            EXPECT_EQ(found.normal, Vec3(0, 0, -1));
        }
    }
}

// A corner lands on the diagonal of a face of the floor: triangles on both sides of it count.
TEST(ContactPoint, OfACubeThatLandsOnADiagonal) {
    const Solid cube(box({0, 0, 0}, {1, 1, 1})), floor(box({-8, -8, -1}, {8, 8, 0}));
    int edges = 0;
    for (const Vec3& motion : {Vec3(2, 1, -1), Vec3(1, 2, -1), Vec3(-3, 4, -1), Vec3(-4, 1, -1)}) {
        const Vec3 landing = motion[1] > 1.5 ? Vec3(1, 1, 0) : Vec3(1, -1, 0);
        const Posed<MeshShape> a{cube, at(landing - 0.5 * motion)}, b{floor, Pose()};
        const auto contact = cast(a, motion, b);
        ASSERT_TRUE(contact);
        edges += contact->kind == ClosestKind::vertex_edge;
        EXPECT_EQ(contact_point(a, motion, b, *contact).normal, Vec3(0, 0, -1));
    }
    EXPECT_GE(edges, 2);
}

TEST(ContactPoint, OfEachKind) {
    const MeshShape sheet(Mesh::create({{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}}, {{0, 1, 2}}));
    const MeshShape tip(
        Mesh::create({{0, 0, 0}, {-1, -1, 2}, {1, -1, 2}, {0, 1, 2}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}}));
    const ContactPoint vertex = point_of({tip, at({0, 0, 1})}, {0.5, 0, -2}, {sheet, Pose()}, ClosestKind::vertex_face);
    EXPECT_EQ(vertex.point, Vec3(0.25, 0, 0));
    EXPECT_EQ(vertex.normal, Vec3(0, 0, -1));
    const ContactPoint from_below =
        point_of({sheet, Pose()}, {-0.5, 0, 2}, {tip, at({0, 0, 1})}, ClosestKind::vertex_face);
    EXPECT_EQ(from_below.point, Vec3(0, 0, 1));  // the vertex of b, which rests
    EXPECT_EQ(from_below.normal, Vec3(0, 0, 1));
    // Two blades that cross: their edges from (-1, 0) to (1, 0) and from (0, -1) to (0, 1).
    const MeshShape upper(Mesh::create({{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}));
    const MeshShape lower(Mesh::create({{0, -1, 0}, {0, 1, 0}, {0, 0, -1}}, {{0, 1, 2}}));
    const ContactPoint edges =
        point_of({upper, at({0.25, 0, 1})}, {0.25, 0.25, -2}, {lower, Pose()}, ClosestKind::edge_edge);
    EXPECT_EQ(edges.point, Vec3(0, 0.125, 0));
    EXPECT_EQ(edges.normal, Vec3(0, 0, -1));
    // The tip meets the edge of the blade: obliquely the normal is the motion less its part along the edge.
    const ContactPoint on_edge =
        point_of({tip, at({0, 0.25, 1})}, {0, 0.75, -1}, {lower, at({0, 0.25, 0})}, ClosestKind::vertex_edge);
    EXPECT_EQ(on_edge.point, Vec3(0, 1, 0));
    EXPECT_EQ(on_edge.normal, Vec3(0, 0, -1));
    // Tip on tip: the motion itself separates them.
    const MeshShape tip_up(
        Mesh::create({{0, 0, 0}, {-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}));
    const ContactPoint tips =
        point_of({tip, at({0.75, 0, 1})}, {-0.75, 0, -1}, {tip_up, Pose()}, ClosestKind::vertex_vertex);
    EXPECT_EQ(tips.point, Vec3(0, 0, 0));
    EXPECT_EQ(tips.normal, Vec3(-0.6, 0, -0.8));
}

// A flat solid without a face has zero-area triangles only, which count.
// A needle falls on the ridge of a roof. Posts at the ends of the ridge share a vertex with it, and are not at the
// edge.
TEST(ContactPoint, TrianglesAtTheEndOfAnEdgeDoNotCount) {
    const std::vector<Vec3> corners{{-2, 0, 0}, {2, 0, 0},  {0, 2, -2}, {0, -2, -2},
                                    {-2, 0, 4}, {-2, 1, 4}, {2, 0, 4},  {2, 1, 4}};
    const std::vector<Triangle> roof{{0, 1, 2}, {0, 3, 1}}, with_posts{{0, 4, 5}, {0, 1, 2}, {0, 3, 1}, {1, 6, 7}};
    const MeshShape needle(Mesh::create({{0, 0, 0}, {0.125, 0, 2}, {-0.125, 0.25, 2}}, {{0, 1, 2}}));
    for (const auto& triangles : {roof, with_posts}) {
        const MeshShape below(Mesh::create(corners, triangles));
        const ContactPoint found =
            point_of({needle, at({0.5, 0, 1})}, {0, 0, -2}, {below, Pose()}, ClosestKind::vertex_edge);
        EXPECT_EQ(found.point, Vec3(0.5, 0, 0));
        EXPECT_EQ(found.normal, Vec3(0, 0, -1));
    }
}

TEST(ContactPoint, OfSegmentsAndPoints) {
    const ConvexSolid point(std::vector<Vec3>{{0, 0, 0}}), rod(std::vector<Vec3>{{0, 0, 0}, {0, 0, 4}});
    const Solid cube(box({-1, -1, -1}, {1, 1, 1}));
    for (const ConvexSolid* const thin : {&point, &rod}) {
        for (const double y : {0.0, 1.0}) {
            const Posed<MeshShape> a{*thin, at({-5, y, -2})}, b{cube, at({0, 0, -1})};
            EXPECT_EQ(point_of(a, {8, 0, 0}, b).normal, Vec3(1, 0, 0)) << y;
        }
    }
}

TEST(ContactPoint, AtTheStart) {
    const Solid cube(box({0, 0, 0}, {1, 1, 1})), small(box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}));
    const ContactPoint touching = point_of({cube, Pose()}, {1, 0, 0}, {cube, at({1, 0, 0})}, ClosestKind::intersecting);
    EXPECT_EQ(touching.point[0], 1);
    EXPECT_FALSE(touching.normal);
    EXPECT_FALSE(point_of({small, Pose()}, {1, 0, 0}, {cube, Pose()}, ClosestKind::contained).normal);
}

TEST(ContactPoint, OfAWorldAndOfOthersContacts) {
    World world;
    const auto floor = world.create_body(std::make_shared<const Solid>(box({-8, -8, -1}, {8, 8, 0})), Pose());
    const Solid cube(box({0, 0, 0}, {1, 1, 1}));
    world.update();
    const Posed<Shape> mover(cube, at({0.25, 0.5, 0.5}));
    const auto contact = world.cast(mover, {0, 0, -1});
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->body, floor);
    EXPECT_EQ(world.contact_point(mover, {0, 0, -1}, *contact).normal, Vec3(0, 0, -1));
    const Rounded soft(std::make_shared<const Solid>(cube.mesh_ptr()), 0.5);
    EXPECT_THROW(static_cast<void>(world.contact_point(Posed<Shape>(soft, Pose()), {0, 0, -1}, *contact)),
                 NotSupported);
    FirstContact other = contact->contact;
    other.a.triangle = 4000;
    EXPECT_THROW(static_cast<void>(contact_point({cube, Pose()}, {0, 0, -1}, {cube, Pose()}, other)), NotSupported);
    EXPECT_THROW(static_cast<void>(contact_point({cube, Pose()}, {0, 0, NAN}, {cube, Pose()}, other)), InvalidArgument);
}

}  // namespace
}  // namespace ecods
