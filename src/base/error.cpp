#include "ecods/error.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/kind_name.hpp"
#include "base/make_error.hpp"
#include "base/misuse.hpp"
#include "base/number_text.hpp"

namespace ecods {
namespace {

std::string text(double x) {
    return decimal_text(x);
}

std::string text(const NotSolid::Coordinates& point) {
    return "(" + text(point[0]) + ", " + text(point[1]) + ", " + text(point[2]) + ")";
}

std::string text(BodyId body) {
    if (!body) return "null body";
    return "body " + std::to_string(body.slot) + "." + std::to_string(body.generation);
}

std::string entry_text(ListIndex index) {
    return index ? "entry " + std::to_string(*index) + ": " : std::string();
}

std::string place_text(BodyId body, ListIndex index) {
    return entry_text(index) + (body ? text(body) + ": " : std::string());
}

std::string pose_entry(int row, int column) {
    const std::string r = std::to_string(row);
    if (row == 3) return "(3, " + std::to_string(column) + ")";
    return column == 3 ? "t(" + r + ")" : "R(" + r + ", " + std::to_string(column) + ")";
}

// Lists the names of questions, indexed by the enumerator's value.
constexpr std::array<std::string_view, 13> question_names = {"relation",       "intersecting_triangles",
                                                             "distance",       "within",
                                                             "closest",        "intersections",
                                                             "close_features", "cast",
                                                             "cast_moving",    "hits",
                                                             "intersects",     "certify",
                                                             "cast_any_motion"};
static_assert(static_cast<std::size_t>(Question::cast_any_motion) + 1 == question_names.size());

std::string name_of(Question question) {
    const auto value = static_cast<std::size_t>(question);
    return value < question_names.size() ? std::string(question_names[value]) : "question " + std::to_string(value);
}

// Returns, for example, "axis 2: coordinate is nan, not finite".
std::string bad_coordinate(int axis, double value) {
    return "axis " + std::to_string(axis) + ": coordinate is " + text(value) + ", not finite";
}

// Returns the name of one coordinate: "min(2)", or "(2)" if `vector` is empty because the argument is a vector itself.
std::string coordinate(const char* vector, int axis) {
    return std::string(vector) + "(" + std::to_string(axis) + ")";
}

// Makes the error for a bad interval [min, max]. The error names the end that is NaN; if neither end is NaN, min > max,
// and the error names the minimum.
InvalidArgument about_box(const std::string& given, int axis, double min, double max) {
    const bool is_max = std::isnan(max) && !std::isnan(min);
    return {given + "[" + text(min) + ", " + text(max) + "] on axis " + std::to_string(axis), Argument::box,
            coordinate(is_max ? "max" : "min", axis), is_max ? max : min};
}

void set_edge(NotSolid& error, const MeshEdge& edge) {
    error.triangle = edge.triangle;
    error.corner = edge.corner;
    error.vertices = edge.vertices;
}

std::string not_supported_text(Question question, ShapeKind a, ShapeKind b, BodyId body) {
    const std::string first = name_of(a), both = "(" + first + ", " + name_of(b) + ")";
    if (question == Question::intersects) return "no two-body test is registered for shapes " + both;
    if (question == Question::certify) {
        return text(body) + " has a shape (" + first + ") of which there are no certificates";
    }
    return (question == Question::hits ? "the shape (" + first + ")" : "the test of shapes " + both) +
           " does not answer " + name_of(question);
}

std::atomic<MisuseHandler> misuse_handler = nullptr;

}  // namespace

InvalidMesh::InvalidMesh(const std::string& text, Reason why) : Error(text), reason(why) {}

InvalidMesh invalid_vertex(std::size_t vertex, int axis, double value) {
    InvalidMesh error("vertex " + std::to_string(vertex) + ", " + bad_coordinate(axis, value),
                      InvalidMesh::Reason::vertex);
    error.vertex = vertex;
    error.axis = axis;
    error.value = value;
    return error;
}

InvalidMesh invalid_index(std::size_t triangle, int corner, std::size_t index, std::size_t vertex_count) {
    InvalidMesh error("triangle " + std::to_string(triangle) + ", corner " + std::to_string(corner) +
                          ": vertex index " + std::to_string(index) + " is out of range; there are " +
                          std::to_string(vertex_count) + " vertices",
                      InvalidMesh::Reason::index);
    error.triangle = triangle;
    error.corner = corner;
    error.index = index;
    error.vertex_count = vertex_count;
    return error;
}

InvalidMesh empty_mesh() {
    return {"mesh has no triangles", InvalidMesh::Reason::empty};
}

InvalidMesh invalid_layout(std::size_t number_count, std::size_t stride) {
    InvalidMesh error(std::to_string(number_count) + " numbers, " + std::to_string(stride) +
                          " from one to the next, do not hold three for each vertex or triangle",
                      InvalidMesh::Reason::layout);
    error.number_count = number_count;
    error.stride = stride;
    return error;
}

InvalidMesh mesh_too_large(std::size_t vertex_count, std::size_t triangle_count) {
    InvalidMesh error("mesh has " + std::to_string(vertex_count) + " vertices and " + std::to_string(triangle_count) +
                          " triangles, more than 32-bit indices can name",
                      InvalidMesh::Reason::too_large);
    error.vertex_count = vertex_count;
    error.triangle_count = triangle_count;
    return error;
}

NotSolid::NotSolid(const std::string& text, Reason why) : Error(text), reason(why) {}

NotSolid open_edge(const MeshEdge& edge, const std::array<NotSolid::Coordinates, 2>& points) {
    NotSolid error("triangle " + std::to_string(edge.triangle) + ": its edge from vertex " +
                       std::to_string(edge.vertices[0]) + " at " + text(points[0]) + " to vertex " +
                       std::to_string(edge.vertices[1]) + " at " + text(points[1]) +
                       " has no other half: the mesh is not closed",
                   NotSolid::Reason::open_edge);
    set_edge(error, edge);
    error.points = points;
    return error;
}

NotSolid self_intersection(const TrianglePair& triangles) {
    NotSolid error("triangles " + std::to_string(triangles.a) + " and " + std::to_string(triangles.b) +
                       " share a segment or more that is not a side of both",
                   NotSolid::Reason::self_intersection);
    error.triangles = triangles;
    return error;
}

NotSolid dent(const MeshEdge& edge, std::size_t beyond, double depth) {
    NotSolid error("triangle " + std::to_string(edge.triangle) + ", at its edge from vertex " +
                       std::to_string(edge.vertices[0]) + " to vertex " + std::to_string(edge.vertices[1]) +
                       ": vertex " + std::to_string(beyond) + " is beyond its plane by " + text(depth) +
                       ": the solid is not convex; ConvexSolid(points), in Python ConvexSolid.hull(points), takes "
                       "the hull of its vertices",
                   NotSolid::Reason::dent);
    set_edge(error, edge);
    error.beyond = beyond;
    error.depth = depth;
    return error;
}

NotSolid no_interior(std::size_t point_count) {
    NotSolid error(point_count == 0
                       ? std::string("there are no points")
                       : "the " + std::to_string(point_count) + " points lie in one plane: there is no interior",
                   NotSolid::Reason::no_interior);
    error.point_count = point_count;
    return error;
}

NotSolid no_area(std::size_t point_count) {
    NotSolid error("no triangle has an area: there is no interior", NotSolid::Reason::no_interior);
    error.point_count = point_count;
    return error;
}

InvalidArgument::InvalidArgument(const std::string& text, Argument what_is_bad, std::string bad_part, double bad_value)
    : Error(text), argument(what_is_bad), part(std::move(bad_part)), value(bad_value) {}

InvalidArgument InvalidArgument::at(BodyId bad_body, ListIndex bad_index) const {
    const std::string without_place = std::string(what()).substr(place_text(body, index).size());
    InvalidArgument error(place_text(bad_body, bad_index) + without_place, argument, part, value);
    error.body = bad_body;
    error.index = bad_index;
    error.kind = kind;
    return error;
}

InvalidArgument invalid_pose(int row, int column, double value) {
    const std::string part = pose_entry(row, column);
    return {"pose entry " + part + " is " + text(value) +
                (row == 3 ? ", where the last row of a matrix is 0 0 0 1" : ", not finite"),
            Argument::pose, part, value};
}

InvalidArgument invalid_box(int axis, double min, double max) {
    return about_box("the box given has ", axis, min, max);
}

InvalidArgument invalid_box(ShapeKind kind, int axis, double min, double max) {
    InvalidArgument error = about_box("shape (" + name_of(kind) + ") gave a box with ", axis, min, max);
    error.kind = kind;
    return error;
}

InvalidArgument invalid_segment(int end, int axis, double value) {
    return {"segment: end " + std::to_string(end) + ", " + bad_coordinate(axis, value), Argument::segment,
            coordinate(end == 0 ? "a" : "b", axis), value};
}

InvalidArgument invalid_origin(int axis, double value) {
    return {"ray: origin, " + bad_coordinate(axis, value), Argument::ray, coordinate("origin", axis), value};
}

InvalidArgument invalid_direction(int axis, double value) {
    return {"ray: direction, " + bad_coordinate(axis, value), Argument::ray, coordinate("direction", axis), value};
}

InvalidArgument no_direction() {
    return {"ray: direction, axis 0: coordinate is 0, as all of the direction", Argument::ray, "direction"};
}

InvalidArgument invalid_max_parameter(double value) {
    return {"ray: the largest parameter is " + text(value), Argument::ray, "max_parameter", value};
}

InvalidArgument invalid_point(int axis, double value) {
    return {"point, " + bad_coordinate(axis, value), Argument::point, coordinate("", axis), value};
}

InvalidArgument invalid_motion(int axis, double value) {
    return {"motion: " + bad_coordinate(axis, value), Argument::motion, coordinate("", axis), value};
}

InvalidArgument invalid_turn(const std::string& part, double value) {
    return {"turn: " + part + " is " + text(value) + ", which is not allowed", Argument::turn, part, value};
}

InvalidArgument whole_turn(double w) {
    return {w < 0 ? "turn: a whole turn has no axis; turn twice" : std::string("turn: the quaternion is zero"),
            Argument::turn, "q", w};
}

InvalidArgument no_rotation_between() {
    return {"the two poses do not differ by a rotation: one of them mirrors, shears or is singular", Argument::pose};
}

InvalidArgument invalid_center(int axis, double value) {
    return {"ball: center, " + bad_coordinate(axis, value), Argument::ball, coordinate("center", axis), value};
}

InvalidArgument invalid_radius(double value) {
    return {"ball: the radius is " + text(value), Argument::ball, "radius", value};
}

InvalidArgument invalid_normal(int axis, double value) {
    return {"half space: normal, " + bad_coordinate(axis, value), Argument::half_space, coordinate("normal", axis),
            value};
}

InvalidArgument no_normal() {
    return {"half space: the normal is zero", Argument::half_space, "normal"};
}

InvalidArgument invalid_offset(double value) {
    return {"half space: the offset is " + text(value), Argument::half_space, "offset", value};
}

InvalidArgument invalid_distance(double value) {
    return {"distance is " + text(value) + ", not a number from 0 that is allowed here", Argument::distance, {}, value};
}

InvalidArgument invalid_time(double value) {
    return {"a time is negative or NaN: " + text(value), Argument::time, {}, value};
}

InvalidArgument invalid_list_length(std::size_t body_count, std::size_t count, const std::string& what) {
    return {
        "a list of " + std::to_string(body_count) + " bodies came with a list of " + std::to_string(count) + " " + what,
        Argument::list_length, what, static_cast<double>(count)};
}

InvalidArgument null_argument(const std::string& name) {
    return {name + " is null", Argument::null, name};
}

InvalidArgument mesh_and_shape() {
    return {"a body was given both a mesh and a shape", Argument::mesh_and_shape};
}

SingularPose::SingularPose(int argument_index, BodyId of_body)
    : Error(of_body
                ? place_text(of_body, {}) + "its pose is singular"
                : std::string("the pose of the ") + (argument_index == 0 ? "first" : "second") + " shape is singular"),
      argument(argument_index),
      body(of_body) {}

StaleBody::StaleBody(BodyId stale, ListIndex list_index)
    : Error(entry_text(list_index) + text(stale) + " is not alive in this world"), body(stale), index(list_index) {}

SameBody::SameBody(BodyId same) : Error(text(same) + " was given twice where a pair was asked for"), body(same) {}

MovedFromWorld::MovedFromWorld() : Error("the world was moved from") {}

NotSupported::NotSupported(Question asked, ShapeKind first, ShapeKind second, BodyId of_body)
    : Error(not_supported_text(asked, first, second, of_body)), question(asked), a(first), b(second), body(of_body) {}

NotUpdated::NotUpdated() : Error("the world changed since its last update") {}

ShapeChanged::ShapeChanged(BodyId of_body, ShapeKind of_kind, const std::string& what_changed)
    : Error(text(of_body) + ": its shape (" + name_of(of_kind) + ") changed its " + what_changed +
            " while the body had it"),
      body(of_body),
      kind(of_kind) {}

TraceFailed::TraceFailed() : Error("the stream of the trace failed; the trace ends before its time") {}

InvalidTrace::InvalidTrace(std::size_t line_number, const std::string& reason)
    : Error("line " + std::to_string(line_number) + ": " + reason), line(line_number) {}

MisuseHandler set_misuse_handler(MisuseHandler handler) noexcept {
    return misuse_handler.exchange(handler);
}

void report_misuse(const Error& error) {
    if (const MisuseHandler handler = misuse_handler.load()) handler(error);
}

}  // namespace ecods
