#include "ecods/error.hpp"

#include <array>
#include <atomic>
#include <charconv>
#include <string_view>

#include "base/misuse.hpp"

namespace ecods {
namespace {

// Returns the shortest decimal that reads back as the same double; NaN and infinities by name.
std::string text(double x) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr;
    return {buffer.data(), end};
}

std::string text(const NotClosed::Coordinates& point) {
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
    return column == 3 ? "t[" + r + "]" : "R(" + r + ", " + std::to_string(column) + ")";
}

// Names questions by the value of the enumerator.
constexpr std::array<std::string_view, 10> question_names = {
    "relation",      "intersecting_triangles", "distance", "within",      "closest",
    "intersections", "close_features",         "cast",     "cast_moving", "hits"};
static_assert(static_cast<std::size_t>(Question::hits) + 1 == question_names.size());

std::string name_of(Question question) {
    const auto value = static_cast<std::size_t>(question);
    return value < question_names.size() ? std::string(question_names[value]) : "question " + std::to_string(value);
}

// Returns, for example, "axis 2: coordinate is nan, not finite".
std::string bad_coordinate(int axis, double value) {
    return "axis " + std::to_string(axis) + ": coordinate is " + text(value) + ", not finite";
}

std::string interval(double min, double max) {
    return "[" + text(min) + ", " + text(max) + "]";
}

std::atomic<MisuseHandler> misuse_handler = nullptr;

}  // namespace

InvalidVertex::InvalidVertex(std::size_t vertex_index, int axis_index, double bad_value)
    : Error("vertex " + std::to_string(vertex_index) + ", " + bad_coordinate(axis_index, bad_value)),
      vertex(vertex_index),
      axis(axis_index),
      value(bad_value) {}

InvalidIndex::InvalidIndex(std::size_t triangle_index, int corner_index, std::size_t bad_value, std::size_t count)
    : Error("triangle " + std::to_string(triangle_index) + ", corner " + std::to_string(corner_index) +
            ": vertex index " + std::to_string(bad_value) + " is out of range; there are " + std::to_string(count) +
            " vertices"),
      triangle(triangle_index),
      corner(corner_index),
      value(bad_value),
      vertex_count(count) {}

EmptyMesh::EmptyMesh() : Error("mesh has no triangles") {}

InvalidLayout::InvalidLayout(std::size_t number_count, std::size_t number_stride)
    : Error(std::to_string(number_count) + " numbers, " + std::to_string(number_stride) +
            " from one to the next, do not hold three for each vertex or triangle"),
      count(number_count),
      stride(number_stride) {}

MeshTooLarge::MeshTooLarge(std::size_t vertices, std::size_t triangles)
    : Error("mesh has " + std::to_string(vertices) + " vertices and " + std::to_string(triangles) +
            " triangles, more than 32-bit indices can name"),
      vertex_count(vertices),
      triangle_count(triangles) {}

NotClosed::NotClosed(std::size_t triangle_index, int corner_index, const std::array<std::size_t, 2>& ends,
                     const std::array<Coordinates, 2>& end_points)
    : Error("triangle " + std::to_string(triangle_index) + ": its edge from vertex " + std::to_string(ends[0]) +
            " at " + text(end_points[0]) + " to vertex " + std::to_string(ends[1]) + " at " + text(end_points[1]) +
            " has no other half: the mesh is not closed"),
      triangle(triangle_index),
      corner(corner_index),
      vertices(ends),
      points(end_points) {}

SelfIntersecting::SelfIntersecting(const TrianglePair& pair)
    : Error("triangles " + std::to_string(pair.a) + " and " + std::to_string(pair.b) +
            " share a segment or more that is not a side of both"),
      triangles(pair) {}

NotConvex::NotConvex(std::size_t triangle_index, int corner_index, const std::array<std::size_t, 2>& ends,
                     std::size_t beyond_index)
    : Error("triangle " + std::to_string(triangle_index) + ", at its edge from vertex " + std::to_string(ends[0]) +
            " to vertex " + std::to_string(ends[1]) + ": vertex " + std::to_string(beyond_index) +
            " is beyond its plane: the solid is not convex"),
      triangle(triangle_index),
      corner(corner_index),
      vertices(ends),
      beyond(beyond_index) {}

NoInterior::NoInterior(std::size_t count)
    : Error(count == 0 ? std::string("there are no points")
                       : "the " + std::to_string(count) + " points lie in one plane: there is no interior"),
      point_count(count) {}

InvalidPose::InvalidPose(int row_index, int column_index, double bad_value, BodyId of_body, ListIndex list_index)
    : Error(place_text(of_body, list_index) + "pose entry " + pose_entry(row_index, column_index) + " is " +
            text(bad_value) + (row_index == 3 ? ", where the last row of a matrix is 0 0 0 1" : ", not finite")),
      row(row_index),
      column(column_index),
      value(bad_value),
      body(of_body),
      index(list_index) {}

SingularPose::SingularPose(int argument_index, BodyId of_body)
    : Error(place_text(of_body, {}) + "the pose of the " + (argument_index == 0 ? "first" : "second") +
            " solid is singular"),
      argument(argument_index),
      body(of_body) {}

SolidsApart::SolidsApart(BodyId first, BodyId second)
    : Error(first && second ? text(first) + " and " + text(second) + " share no point: there is no depth"
                            : std::string("the solids share no point: there is no depth")),
      a(first),
      b(second) {}

LengthMismatch::LengthMismatch(std::size_t bodies, std::size_t poses)
    : Error("a list of " + std::to_string(bodies) + " bodies came with a list of " + std::to_string(poses) + " poses"),
      body_count(bodies),
      pose_count(poses) {}

NullArgument::NullArgument(const std::string& argument) : Error(argument + " is null") {}

StaleBody::StaleBody(BodyId stale, ListIndex list_index)
    : Error(entry_text(list_index) + text(stale) + " is not alive in this world"), body(stale), index(list_index) {}

MovedFromWorld::MovedFromWorld() : Error("the world was moved from") {}

MeshAndShape::MeshAndShape() : Error("a body was given both a mesh and a shape") {}

SameBody::SameBody(BodyId same) : Error(text(same) + " was given twice where a pair was asked for"), body(same) {}

MissingTest::MissingTest(ShapeKind first, ShapeKind second)
    : Error("no two-body test is registered for shape kinds " + std::to_string(first.value) + " and " +
            std::to_string(second.value)),
      a(first),
      b(second) {}

NotSupported::NotSupported(Question asked, ShapeKind first, ShapeKind second)
    : Error((asked == Question::hits
                 ? "the shape of kind " + std::to_string(first.value)
                 : "the test of shape kinds " + std::to_string(first.value) + " and " + std::to_string(second.value)) +
            " does not answer " + name_of(asked)),
      question(asked),
      a(first),
      b(second) {}

InvalidBox::InvalidBox(ShapeKind of_kind, int axis_index, double box_min, double box_max, BodyId of_body,
                       ListIndex list_index)
    : Error(place_text(of_body, list_index) + "shape of kind " + std::to_string(of_kind.value) + " gave a box with " +
            interval(box_min, box_max) + " on axis " + std::to_string(axis_index)),
      kind(of_kind),
      axis(axis_index),
      min(box_min),
      max(box_max),
      body(of_body),
      index(list_index) {}

InvalidBox::InvalidBox(int axis_index, double box_min, double box_max)
    : Error("the box given has " + interval(box_min, box_max) + " on axis " + std::to_string(axis_index)),
      axis(axis_index),
      min(box_min),
      max(box_max) {}

InvalidSegment::InvalidSegment(int end_index, int axis_index, double bad_value)
    : Error("segment: end " + std::to_string(end_index) + ", " + bad_coordinate(axis_index, bad_value)),
      end(end_index),
      axis(axis_index),
      value(bad_value) {}

InvalidRay::InvalidRay(Part bad_part, int axis_index, double bad_value)
    : Error(bad_part == Part::parameter_max
                ? "ray: the largest parameter is " + text(bad_value)
                : "ray: " + std::string(bad_part == Part::origin ? "origin" : "direction") + ", axis " +
                      std::to_string(axis_index) + ": coordinate is " + text(bad_value) +
                      (bad_value == 0 ? ", as all of the direction" : ", not finite")),
      part(bad_part),
      axis(axis_index),
      value(bad_value) {}

InvalidMotion::InvalidMotion(int axis_index, double bad_value)
    : Error("motion: " + bad_coordinate(axis_index, bad_value)), axis(axis_index), value(bad_value) {}

InvalidPoint::InvalidPoint(int axis_index, double bad_value)
    : Error("point, " + bad_coordinate(axis_index, bad_value)), axis(axis_index), value(bad_value) {}

InvalidBall::InvalidBall(int axis_index, double bad_value)
    : Error(axis_index == 3 ? "ball: the radius is " + text(bad_value)
                            : "ball: center, " + bad_coordinate(axis_index, bad_value)),
      axis(axis_index),
      value(bad_value) {}

InvalidTime::InvalidTime(double time) : Error("a time is negative or NaN: " + text(time)), value(time) {}

InvalidDistance::InvalidDistance(double bad_value)
    : Error("distance is " + text(bad_value) + ", not a number from 0 that is allowed here"), value(bad_value) {}

ShapeChanged::ShapeChanged(BodyId of_body, ShapeKind of_kind, const std::string& what_changed)
    : Error(text(of_body) + ": its shape, of kind " + std::to_string(of_kind.value) + ", changed its " + what_changed +
            " while the body had it"),
      body(of_body),
      kind(of_kind) {}

NotUpdated::NotUpdated() : Error("the world changed since its last update") {}

NotCertified::NotCertified(BodyId certified, ShapeKind shape_kind)
    : Error(text(certified) + " has a shape of kind " + std::to_string(shape_kind.value) +
            ", of which there are no certificates"),
      body(certified),
      kind(shape_kind) {}

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
