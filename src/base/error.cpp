#include "ecods/error.hpp"

#include <array>
#include <atomic>
#include <charconv>

#include "base/misuse.hpp"

namespace ecods {
namespace {

// The shortest decimal that reads back as the same double; NaN and infinities by name.
std::string text(double x) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr;
    return {buffer.data(), end};
}

std::string text(BodyId body) {
    if (!body) return "null body";
    return "body " + std::to_string(body.slot) + "." + std::to_string(body.generation);
}

std::string pose_entry(int row, int column) {
    const std::string r = std::to_string(row);
    return column == 3 ? "t[" + r + "]" : "R(" + r + ", " + std::to_string(column) + ")";
}

std::atomic<MisuseHandler> misuse_handler = nullptr;

}  // namespace

InvalidVertex::InvalidVertex(std::size_t vertex_index, int axis_index, double bad_value)
    : Error("vertex " + std::to_string(vertex_index) + ", axis " + std::to_string(axis_index) + ": coordinate is " +
            text(bad_value) + ", not finite"),
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

MeshTooLarge::MeshTooLarge(std::size_t vertices, std::size_t triangles)
    : Error("mesh has " + std::to_string(vertices) + " vertices and " + std::to_string(triangles) +
            " triangles, more than 32-bit indices can name"),
      vertex_count(vertices),
      triangle_count(triangles) {}

InvalidPose::InvalidPose(int row_index, int column_index, double bad_value, BodyId of_body)
    : Error((of_body ? text(of_body) + ": " : std::string()) + "pose entry " + pose_entry(row_index, column_index) +
            " is " + text(bad_value) + ", not finite"),
      row(row_index),
      column(column_index),
      value(bad_value),
      body(of_body) {}

NullArgument::NullArgument(const std::string& argument) : Error(argument + " is null") {}

StaleBody::StaleBody(BodyId stale) : Error(text(stale) + " is not alive in this world"), body(stale) {}

SameBody::SameBody(BodyId same) : Error(text(same) + " was given twice where a pair was asked for"), body(same) {}

MissingTest::MissingTest(ShapeKind first, ShapeKind second)
    : Error("no two-body test is registered for shape kinds " + std::to_string(first.value) + " and " +
            std::to_string(second.value)),
      a(first),
      b(second) {}

InvalidBox::InvalidBox(ShapeKind of_kind, int axis_index, double box_min, double box_max)
    : Error("shape of kind " + std::to_string(of_kind.value) + " gave a box with [" + text(box_min) + ", " +
            text(box_max) + "] on axis " + std::to_string(axis_index)),
      kind(of_kind),
      axis(axis_index),
      min(box_min),
      max(box_max) {}

MisuseHandler set_misuse_handler(MisuseHandler handler) noexcept {
    return misuse_handler.exchange(handler);
}

void report_misuse(const Error& error) {
    if (const MisuseHandler handler = misuse_handler.load()) handler(error);
}

}  // namespace ecods
