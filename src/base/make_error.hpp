// The functions below make the errors about bad input. Their texts are in error.cpp and builder_errors.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "ecods/error.hpp"

namespace ecods {

InvalidMesh invalid_vertex(std::size_t vertex, int axis, double value);
InvalidMesh invalid_index(std::size_t triangle, int corner, std::size_t index, std::size_t vertex_count);
InvalidMesh empty_mesh();
InvalidMesh invalid_layout(std::size_t number_count, std::size_t stride);
InvalidMesh mesh_too_large(std::size_t vertex_count, std::size_t triangle_count);

// Names a directed edge of a triangle in an error: it goes from corner `corner` of the triangle to the next corner.
struct MeshEdge {
    std::size_t triangle;
    int corner;
    std::array<std::size_t, 2> vertices;
};

NotSolid open_edge(const MeshEdge& edge, const std::array<NotSolid::Coordinates, 2>& points);
NotSolid self_intersection(const TrianglePair& triangles);
NotSolid dent(const MeshEdge& edge, std::size_t beyond, double depth);
NotSolid no_interior(std::size_t point_count);
NotSolid no_area(std::size_t point_count);  // no triangle of a mesh has an area

InvalidArgument invalid_pose(int row, int column, double value);  // row and column of the 4x4 matrix [R t; 0 0 0 1]
InvalidArgument invalid_box(int axis, double min, double max);
InvalidArgument invalid_box(ShapeKind kind, int axis, double min, double max);  // the box that a shape returned
InvalidArgument invalid_segment(int end, int axis, double value);
InvalidArgument invalid_origin(int axis, double value);  // about a ray, like the next three functions
InvalidArgument invalid_direction(int axis, double value);
InvalidArgument no_direction();
InvalidArgument invalid_max_parameter(double value);
InvalidArgument invalid_point(int axis, double value);
InvalidArgument invalid_motion(int axis, double value);
InvalidArgument invalid_turn(const std::string& part, double value);
InvalidArgument whole_turn(double w);
InvalidArgument no_rotation_between();
InvalidArgument invalid_center(int axis, double value);  // about a ball, like the next function
InvalidArgument invalid_radius(double value);
InvalidArgument invalid_normal(int axis, double value);  // about a half space, like the next two functions
InvalidArgument no_normal();
InvalidArgument invalid_offset(double value);
InvalidArgument invalid_distance(double value);
InvalidArgument invalid_time(double value);
// Makes the error for a list of `count` entries beside a list of `body_count` bodies. `what` names the entries.
InvalidArgument invalid_list_length(std::size_t body_count, std::size_t count, const std::string& what = "poses");
InvalidArgument null_argument(const std::string& name);
InvalidArgument mesh_and_shape();
// The functions below make errors about the numbers given to builders.
InvalidArgument invalid_size(const std::string& part, double value);
InvalidArgument size_not_even(const std::string& part, double value);  // half of the value is no double
InvalidArgument size_too_large(const std::string& part, double value);
InvalidArgument invalid_base(double value);  // of a height field
InvalidArgument invalid_count(const std::string& part, std::size_t count, std::size_t min, std::size_t max);
InvalidArgument invalid_rows(std::size_t height_count, std::size_t columns);
InvalidArgument polygon_not_convex(std::size_t index);

}  // namespace ecods
