#include "ecods/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/make_error.hpp"

namespace ecods {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr BodyId body{3, 1};

struct Expected {
    InvalidArgument error;
    Argument argument;
    const char* part;
    double value;
    const char* text;
};

TEST(Errors, OfArgumentsNamePartAndValue) {
    const Expected all[] = {
        {invalid_pose(0, 1, nan), Argument::pose, "R(0, 1)", nan, "pose entry R(0, 1) is nan, not finite"},
        {invalid_pose(2, 3, -HUGE_VAL), Argument::pose, "t(2)", -HUGE_VAL, "pose entry t(2) is -inf, not finite"},
        {invalid_pose(3, 3, 0.1), Argument::pose, "(3, 3)", 0.1,
         "pose entry (3, 3) is 0.1, where the last row of a matrix is 0 0 0 1"},
        {invalid_box(1, 2, -1), Argument::box, "min(1)", 2, "the box given has [2, -1] on axis 1"},
        {invalid_box(2, nan, nan), Argument::box, "min(2)", nan, "the box given has [nan, nan] on axis 2"},
        {invalid_box(2, 0, nan), Argument::box, "max(2)", nan, "the box given has [0, nan] on axis 2"},
        {invalid_box(ShapeKind{7}, 0, 1, 0), Argument::box, "min(0)", 1,
         "shape (kind 7) gave a box with [1, 0] on axis 0"},
        {invalid_segment(0, 2, nan), Argument::segment, "a(2)", nan,
         "segment: end 0, axis 2: coordinate is nan, not finite"},
        {invalid_segment(1, 0, nan), Argument::segment, "b(0)", nan,
         "segment: end 1, axis 0: coordinate is nan, not finite"},
        {invalid_origin(1, nan), Argument::ray, "origin(1)", nan, "ray: origin, axis 1: coordinate is nan, not finite"},
        {invalid_direction(2, nan), Argument::ray, "direction(2)", nan,
         "ray: direction, axis 2: coordinate is nan, not finite"},
        {no_direction(), Argument::ray, "direction", 0,
         "ray: direction, axis 0: coordinate is 0, as all of the direction"},
        {invalid_max_parameter(-1), Argument::ray, "max_parameter", -1, "ray: the largest parameter is -1"},
        {invalid_point(1, nan), Argument::point, "(1)", nan, "point, axis 1: coordinate is nan, not finite"},
        {invalid_motion(1, nan), Argument::motion, "(1)", nan, "motion: axis 1: coordinate is nan, not finite"},
        {invalid_center(1, nan), Argument::ball, "center(1)", nan,
         "ball: center, axis 1: coordinate is nan, not finite"},
        {invalid_radius(-0.5), Argument::ball, "radius", -0.5, "ball: the radius is -0.5"},
        {invalid_distance(-0x1p-1074), Argument::distance, "", -0x1p-1074,
         "distance is -5e-324, not a number from 0 that is allowed here"},
        {invalid_time(nan), Argument::time, "", nan, "a time is negative or NaN: nan"},
        {invalid_list_length(5, 4), Argument::list_length, "poses", 4,
         "a list of 5 bodies came with a list of 4 poses"},
        {null_argument("mesh"), Argument::null, "mesh", 0, "mesh is null"},
        {mesh_and_shape(), Argument::mesh_and_shape, "", 0, "a body was given both a mesh and a shape"},
        {invalid_size("radius", -1), Argument::size, "radius", -1, "radius is -1, not finite and positive"},
        {size_not_even("height", 0x1p-1074), Argument::size, "height", 0x1p-1074,
         "height is 5e-324, and half of it is no double"},
        {size_too_large("radii(2)", 0x1p1023), Argument::size, "radii(2)", 0x1p1023,
         "radii(2) is 8.98846567431158e+307: a vertex would be infinite"},
        {invalid_base(nan), Argument::size, "base", nan, "base is nan, not finite and below all heights"},
        {invalid_count("sides", 2, 3, 9), Argument::count, "sides", 2, "sides is 2, not from 3 to 9"},
        {invalid_rows(7, 3), Argument::count, "columns", 3, "7 heights do not make rows of 3 columns"},
    };
    for (const Expected& expected : all) {
        EXPECT_STREQ(expected.error.what(), expected.text);
        EXPECT_EQ(expected.error.argument, expected.argument) << expected.text;
        EXPECT_EQ(expected.error.part, expected.part) << expected.text;
        EXPECT_EQ(std::isnan(expected.error.value), std::isnan(expected.value)) << expected.text;
        if (!std::isnan(expected.value)) {
            EXPECT_EQ(expected.error.value, expected.value) << expected.text;
        }
        EXPECT_FALSE(expected.error.body || expected.error.index) << expected.text;
    }
}

TEST(Errors, OfArgumentsGoWithTheirPlace) {
    const InvalidArgument placed = invalid_box(ShapeKind{7}, 0, 1, 0).at(body, 2);
    EXPECT_STREQ(placed.what(), "entry 2: body 3.1: shape (kind 7) gave a box with [1, 0] on axis 0");
    EXPECT_EQ(placed.argument, Argument::box);
    EXPECT_EQ(placed.part, "min(0)");
    EXPECT_EQ(placed.value, 1);
    EXPECT_EQ(placed.kind, ShapeKind{7});
    EXPECT_EQ(placed.body, body);
    EXPECT_EQ(placed.index, 2u);
    const InvalidArgument elsewhere = placed.at({}, 5);
    EXPECT_STREQ(elsewhere.what(), "entry 5: shape (kind 7) gave a box with [1, 0] on axis 0");
    EXPECT_FALSE(elsewhere.body);
    EXPECT_EQ(elsewhere.index, 5u);
}

// No test can make a mesh that large.
TEST(Errors, OfMeshesThatAreTooLarge) {
    const InvalidMesh error = mesh_too_large(std::size_t{1} << 32, 7);
    EXPECT_STREQ(error.what(), "mesh has 4294967296 vertices and 7 triangles, more than 32-bit indices can name");
    EXPECT_EQ(error.reason, InvalidMesh::Reason::too_large);
    EXPECT_EQ(error.vertex_count, std::size_t{1} << 32);
    EXPECT_EQ(error.triangle_count, 7u);
}

TEST(Errors, OfMeshesNameTheElement) {
    EXPECT_STREQ(empty_mesh().what(), "mesh has no triangles");
    EXPECT_STREQ(invalid_vertex(4, 2, nan).what(), "vertex 4, axis 2: coordinate is nan, not finite");
    EXPECT_STREQ(invalid_index(2, 1, 9, 8).what(),
                 "triangle 2, corner 1: vertex index 9 is out of range; there are 8 vertices");
    const InvalidMesh layout = invalid_layout(11, 3);
    EXPECT_STREQ(layout.what(), "11 numbers, 3 from one to the next, do not hold three for each vertex or triangle");
    EXPECT_EQ(layout.number_count, 11u);
    EXPECT_EQ(layout.stride, 3u);
}

TEST(Errors, OfSolidsNameTheDefect) {
    const MeshEdge edge{5, 2, {8, 6}};
    const NotSolid open = open_edge(edge, {{{0, 0.5, 1}, {1, 0, -2}}});
    EXPECT_STREQ(open.what(),
                 "triangle 5: its edge from vertex 8 at (0, 0.5, 1) to vertex 6 at (1, 0, -2) has no other half: the "
                 "mesh is not closed");
    EXPECT_EQ(open.points[1][2], -2);
    EXPECT_STREQ(self_intersection({1, 4}).what(),
                 "triangles 1 and 4 share a segment or more that is not a side of both");
    const NotSolid dented = dent(edge, 3, 0x1p-52);
    EXPECT_STREQ(dented.what(),
                 "triangle 5, at its edge from vertex 8 to vertex 6: vertex 3 is beyond its plane by "
                 "2.220446049250313e-16: the solid is not convex; ConvexSolid(points), in Python "
                 "ConvexSolid.hull(points), takes the hull of its vertices");
    EXPECT_EQ(dented.triangle, 5u);
    EXPECT_EQ(dented.corner, 2);
    EXPECT_EQ(dented.beyond, 3u);
    EXPECT_EQ(dented.depth, 0x1p-52);
    EXPECT_STREQ(no_interior(0).what(), "there are no points");
    EXPECT_STREQ(no_interior(5).what(), "the 5 points lie in one plane: there is no interior");
    EXPECT_EQ(no_interior(5).point_count, 5u);
}

TEST(Errors, OfQuestionsNameKindsAndQuestion) {
    const ShapeKind a{7}, b = ShapeKind::mesh();
    EXPECT_STREQ(NotSupported(Question::cast, a, b).what(), "the test of shapes (kind 7, mesh) does not answer cast");
    EXPECT_STREQ(NotSupported(Question::hits, a, a).what(), "the shape (kind 7) does not answer hits");
    EXPECT_STREQ(NotSupported(Question::intersects, a, b).what(),
                 "no two-body test is registered for shapes (kind 7, mesh)");
    const NotSupported uncertified(Question::certify, a, a, body);
    EXPECT_STREQ(uncertified.what(), "body 3.1 has a shape (kind 7) of which there are no certificates");
    EXPECT_EQ(uncertified.body, body);
    EXPECT_FALSE(NotSupported("a shape").question);
}

}  // namespace
}  // namespace ecods
