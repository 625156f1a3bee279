// Errors are types: one class for each thing that a caller can do about it.
//
//   fix the mesh         InvalidMesh, NotSolid
//   fix the argument     InvalidArgument, SingularPose, InvalidTrace
//   fix the program      StaleBody, SameBody, MovedFromWorld, NotSupported, NotUpdated, ShapeChanged
//   look elsewhere       ExecutorFailed (the executor), TraceFailed (the stream), BrokenInvariant (this library)
//
// Every error is thrown by the call that brought the bad input in, before anything has changed: the world,
// and every other object, is as it was. what() names the body, mesh element and value in full precision;
// the members give the same for programs. Members that the reason does not list keep their defaults.
//
// A failed allocation is std::bad_alloc, and an exception out of a caller's own shape or test passes through.
//
// Example: verify/examples/how_do_i, catch_an_error().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "ecods/export.hpp"
#include "ecods/ids.hpp"

namespace ecods {

// Error is the base of all errors: catch it to catch them all.
class ECODS_API Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Vertices and indices do not make a mesh.
class ECODS_API InvalidMesh final : public Error {
  public:
    enum class Reason : std::uint8_t {
        empty,      // there is no triangle (the mesh would be apart from everything, which nobody means)
        vertex,     // a coordinate is NaN or infinite: vertex, axis, value
        index,      // a triangle names a vertex that does not exist: triangle, corner, index, vertex_count
        layout,     // numbers do not make whole vertices, or whole triangles: number_count, stride
        too_large,  // 32-bit indices cannot name all: vertex_count, triangle_count
    };

    InvalidMesh(const std::string& text, Reason why);

    Reason reason;
    std::size_t vertex = 0;  // index in the vertex list
    int axis = 0;            // 0 to 2
    double value = 0;
    std::size_t triangle = 0;  // index in the triangle list
    int corner = 0;            // 0 to 2
    std::size_t index = 0;     // the index that is out of range
    std::size_t vertex_count = 0;
    std::size_t triangle_count = 0;
    std::size_t number_count = 0;
    std::size_t stride = 0;  // from one vertex, or one triangle, to the next
};

// A mesh, or a list of points, bounds no solid, or none that is convex where it must be.
class ECODS_API NotSolid final : public Error {
  public:
    using Coordinates = std::array<double, 3>;

    enum class Reason : std::uint8_t {
        // An end of an edge is the end of an odd number of edges along its line: triangle, corner, vertices, points.
        open_edge,
        // Two triangles share a segment or more that is not a side of both: triangles.
        self_intersection,
        // A vertex is beyond the plane of a triangle, so the solid is not convex: triangle, corner, vertices, beyond.
        // The named edge is, if possible, one whose other triangle has that vertex.
        dent,
        // All points lie in one plane, or there are none: point_count.
        no_interior,
    };

    NotSolid(const std::string& text, Reason why);

    Reason reason;
    std::size_t triangle = 0;                  // index in the triangle list
    int corner = 0;                            // 0 to 2: the edge goes from this corner of the triangle to the next one
    std::array<std::size_t, 2> vertices = {};  // the indices of the edge's ends
    std::array<Coordinates, 2> points = {};    // the coordinates of the edge's ends
    TrianglePair triangles = {};               // the lesser index first
    std::size_t beyond = 0;                    // the index of the vertex
    std::size_t point_count = 0;
};

// ListIndex is the position of the bad entry in a list that was given; nothing if there was no list.
using ListIndex = std::optional<std::size_t>;

// Argument says what was bad. The texts in quotes are values of `part`.
enum class Argument : std::uint8_t {
    pose,         // an entry "R(0, 1)" or "t(2)" is NaN or infinite, or "(3, 0)" of a matrix's last row is not 0 0 0 1
    box,          // "min(1)" is NaN or above the maximum, or "max(1)" is NaN
    segment,      // a coordinate "a(0)" or "b(0)" is NaN or infinite
    ray,          // "origin(0)" or "direction(0)" is NaN or infinite, "direction" zero, "max_parameter" NaN or negative
    point,        // a coordinate "(0)" is NaN or infinite
    motion,       // a coordinate "(0)" is NaN or infinite
    ball,         // "center(0)" is NaN or infinite, or "radius" NaN or negative
    distance,     // NaN or negative, or infinite where it must not be
    time,         // a limit is NaN or negative
    list_length,  // two lists that belong together differ: the number of "poses" is not that of the bodies
    null,         // a "mesh", "shape" or "test" is null
    mesh_and_shape,  // a body was to be made of both (BodyOptions)
};

// A number or pointer that a call was given cannot be used.
class ECODS_API InvalidArgument final : public Error {
  public:
    InvalidArgument(const std::string& text, Argument what_is_bad, std::string bad_part = {}, double bad_value = 0);

    // The error with the body that the argument is for, and its place in a list: the text begins with them.
    InvalidArgument at(BodyId bad_body, ListIndex bad_index = {}) const;

    Argument argument;
    std::string part;
    double value;
    BodyId body = {};  // null if the argument was not for a body, or not yet
    ListIndex index = {};
    ShapeKind kind = {};  // box: the kind of the caller's own shape that returned it; mesh() if it was an argument
};

// The matrix of a pose is singular, where a question needs inner points of the solid at it.
class ECODS_API SingularPose final : public Error {
  public:
    explicit SingularPose(int argument, BodyId body = {});

    int argument;  // 0: the pose of the first solid asked about; 1: that of the second
    BodyId body;   // the body, where a World was asked
};

// An id names no body of this world: it is null, of a destroyed body, or of another world.
class ECODS_API StaleBody final : public Error {
  public:
    explicit StaleBody(BodyId body, ListIndex index = {});

    BodyId body;
    ListIndex index;
};

// A pair was needed, but both ids name one body.
class ECODS_API SameBody final : public Error {
  public:
    explicit SameBody(BodyId body);

    BodyId body;
};

// A world was asked that was moved from. It can be assigned to and destroyed, and has no body; every other call throws.
class ECODS_API MovedFromWorld final : public Error {
  public:
    MovedFromWorld();
};

// Two shapes were asked a question that the test of their kinds does not answer, a shape one that it does not answer
// itself, or a shape cannot be used in this way.
class ECODS_API NotSupported final : public Error {
  public:
    // With Question::intersects, no test for the two kinds is registered. With hits and certify, both kinds are those
    // of the one shape.
    NotSupported(Question question, ShapeKind a, ShapeKind b, BodyId body = {});
    using Error::Error;  // not about a question

    std::optional<Question> question = {};
    ShapeKind a = {};  // with `question`: the kinds, in the order in which their test is registered
    ShapeKind b = {};
    BodyId body = {};  // certify: the body of that shape
};

// A certificate was asked of a world that changed since its last update.
class ECODS_API NotUpdated final : public Error {
  public:
    NotUpdated();
};

// The box or digest of a user-defined shape changed since its body got it. Thrown by check_invariants() only.
class ECODS_API ShapeChanged final : public Error {
  public:
    ShapeChanged(BodyId body, ShapeKind kind, const std::string& what_changed);

    BodyId body;
    ShapeKind kind;
};

// An Executor did not run each task once, or ran two at once as the same worker.
class ECODS_API ExecutorFailed final : public Error {
  public:
    using Error::Error;
};

// The stream of a trace failed while the world wrote to it, and the trace ends there. Thrown by World::end_trace only.
class ECODS_API TraceFailed final : public Error {
  public:
    TraceFailed();
};

// A text is not a trace, or holds a call that a World refuses.
class ECODS_API InvalidTrace final : public Error {
  public:
    InvalidTrace(std::size_t line, const std::string& reason);

    std::size_t line;  // from 1
};

// An invariant does not hold: a defect in this library, or memory overwritten. Thrown by check_invariants() only.
class ECODS_API BrokenInvariant final : public Error {
  public:
    using Error::Error;
};

// The handler is called before StaleBody, SameBody or MovedFromWorld, mistakes that are a program's own, is thrown, so
// that a debugger or a log sees the place. The default does nothing; null restores it. set_misuse_handler() returns the
// handler that was set before, and is safe from any thread.
using MisuseHandler = void (*)(const Error&);
ECODS_API MisuseHandler set_misuse_handler(MisuseHandler handler) noexcept;

}  // namespace ecods
