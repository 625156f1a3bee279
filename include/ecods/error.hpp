// Errors are types: there is one class for each thing that a caller can do about an error.
//
//   fix the mesh         InvalidMesh, NotSolid
//   fix the argument     InvalidArgument, SingularPose, InvalidTrace
//   fix the program      StaleBody, SameBody, MovedFromWorld, NotSupported, NotUpdated, ShapeChanged
//   look elsewhere       ExecutorFailed (the executor), TraceFailed (the stream), BrokenInvariant (this library)
//
// The call that is given the bad input throws the error, before it changes the world or any other object. what() names
// the body, mesh element and value in full precision; the members hold the same for programs. The comment at each
// reason lists the members that it sets; all other members keep their defaults.
//
// If an allocation fails, std::bad_alloc is thrown. An exception of a caller's own shape or test passes through.
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

// Error is the base class of all errors; catch it to catch them all.
class ECODS_API Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// InvalidMesh is thrown if vertices and indices do not make a mesh.
class ECODS_API InvalidMesh final : public Error {
  public:
    enum class Reason : std::uint8_t {
        empty,      // there is no triangle: such a mesh would be apart from everything, which nobody intends
        vertex,     // a coordinate is NaN or infinite: vertex, axis, value
        index,      // a triangle names a vertex that does not exist: triangle, corner, index, vertex_count
        layout,     // the numbers do not make whole vertices or triangles: number_count, stride
        too_large,  // there are too many for 32-bit indices: vertex_count, triangle_count
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

// NotSolid is thrown if a mesh or a list of points bounds no solid, or bounds no convex solid where one is needed.
class ECODS_API NotSolid final : public Error {
  public:
    using Coordinates = std::array<double, 3>;

    enum class Reason : std::uint8_t {
        // An edge is not closed by other edges along its line: one of its ends is an end of an odd number of edges
        // there. Sets triangle, corner, vertices, points.
        open_edge,
        // Two triangles share a segment or more that is not a side of both. Sets triangles.
        self_intersection,
        // A vertex is beyond the plane of a triangle, so the solid is not convex. Sets triangle, corner, vertices,
        // beyond, depth. The named edge is, if possible, one whose other triangle has that vertex. A box that was
        // turned and rounded has dents as deep as a few units of rounding; ConvexSolid(points) takes the hull of its
        // vertices.
        dent,
        // No triangle has an area; or, for prism(), all points lie on one line; or there are no points. Sets
        // point_count. ConvexSolid does accept points in one plane, and meshes that cover a polygon, a segment or a
        // point.
        no_interior,
    };

    NotSolid(const std::string& text, Reason why);

    Reason reason;
    std::size_t triangle = 0;                  // index in the triangle list
    int corner = 0;                            // 0 to 2; the edge goes from this corner to the next one
    std::array<std::size_t, 2> vertices = {};  // the indices of the edge's ends
    std::array<Coordinates, 2> points = {};    // the coordinates of the edge's ends
    TrianglePair triangles = {};               // the lesser index first
    std::size_t beyond = 0;                    // the index of the vertex beyond the triangle's plane
    double depth = 0;                          // its distance from the triangle's plane, rounded once
    std::size_t point_count = 0;
};

// A ListIndex is the position of the bad entry in a list that was passed; it is empty if no list was passed.
using ListIndex = std::optional<std::size_t>;

// Argument says which argument is bad. The texts in quotes are values of InvalidArgument::part.
enum class Argument : std::uint8_t {
    pose,         // an entry "R(0, 1)" or "t(2)" is NaN or infinite, or "(3, 0)" of a matrix's last row is not 0 0 0 1
    box,          // "min(1)" is NaN or above the maximum, or "max(1)" is NaN
    segment,      // a coordinate "a(0)" or "b(0)" is NaN or infinite
    ray,          // "origin(0)" or "direction(0)" is NaN or infinite, "direction" zero, "max_parameter" NaN or negative
    point,        // a coordinate "(0)" is NaN or infinite
    motion,       // a coordinate "(0)" is NaN or infinite; all are zero in a direction of depth_along()
    ball,         // "center(0)" is NaN or infinite, or "radius" NaN or negative; of a rounded shape also infinite
    half_space,   // "normal(0)" or "offset" is NaN or infinite, or "normal" zero
    distance,     // NaN or negative, or infinite where it must not be; "max_gap" is NaN or -infinity
    time,         // a limit is NaN or negative
    list_length,  // two lists that belong together differ: the number of "poses" or "motions" is not that of the bodies
    null,         // a "mesh", "shape" or "test" is null
    mesh_and_shape,  // both were given to create a body (BodyOptions)
    size,            // of a builder: "radius", "height", "sizes(0)", "radii(2)", "spacing(1)", "base" is not allowed;
                     // of a contact patch: "min_cos_squared" is not
    count,    // of a builder: "sides", "subdivisions", "columns" or "rows" are too few or too many, or make no grid
    polygon,  // of a builder: the polygon is not convex at point `index`
    turn,  // "q.w", "q.x", "pivot_from(0)", "pivot_to(2)", "axis(0)", "pivot(0)" or "angle" is NaN or infinite; "q" is
           // zero or a whole turn; "axis" is zero; "angle" is a whole turn or more, or negative where it must not be;
           // of a way the node is at `index`, whose "pivot(0)" or "q" may be bad, or "nodes" are too few
};

// InvalidArgument is thrown if a call cannot use a number or pointer that it was given.
class ECODS_API InvalidArgument final : public Error {
  public:
    InvalidArgument(const std::string& text, Argument what_is_bad, std::string bad_part = {}, double bad_value = 0);

    // Returns the error with the body that has the bad argument, and its index in a list. The text begins with both.
    InvalidArgument at(BodyId bad_body, ListIndex bad_index = {}) const;

    Argument argument;
    std::string part;
    double value;
    BodyId body = {};  // null if the argument is not for a body that exists
    ListIndex index = {};
    ShapeKind kind = {};  // if the argument is a box: the kind of the caller's shape that returned it; otherwise mesh()
};

// SingularPose is thrown if the matrix of a pose is singular, but the question needs inner points of the posed solid.
// It is also thrown wherever a half space gets a singular pose, as an argument of a question or by a call of a World.
class ECODS_API SingularPose final : public Error {
  public:
    explicit SingularPose(int argument, BodyId body = {});

    int argument;  // 0: the pose of the first shape of the question is singular; 1: that of the second
    BodyId body;   // the body, if a World was asked, or was to pose a body
};

// StaleBody is thrown if an id names no body of this world: it is null, its body was destroyed, or it is of another
// world.
class ECODS_API StaleBody final : public Error {
  public:
    explicit StaleBody(BodyId body, ListIndex index = {});

    BodyId body;
    ListIndex index;
};

// SameBody is thrown if a pair is needed, but both ids name the same body.
class ECODS_API SameBody final : public Error {
  public:
    explicit SameBody(BodyId body);

    BodyId body;
};

// MovedFromWorld is thrown by a world that was moved from, which has no bodies, and can only be assigned to and
// destroyed.
class ECODS_API MovedFromWorld final : public Error {
  public:
    MovedFromWorld();
};

// NotSupported is thrown if a two-body test or a shape does not answer a question, or if a shape cannot be used as
// requested.
class ECODS_API NotSupported final : public Error {
  public:
    // With Question::intersects, no test of the two kinds is registered. With hits and certify, `a` and `b` are both
    // the kind of one shape.
    NotSupported(Question question, ShapeKind a, ShapeKind b, BodyId body = {});
    using Error::Error;  // for errors that are not about a question

    std::optional<Question> question = {};
    ShapeKind a = {};  // if `question` is set: the kinds, in the order in which their test is registered
    ShapeKind b = {};
    BodyId body = {};  // for certify: the body of the shape
};

// NotUpdated is thrown if a certificate is requested of a world that changed since its last update.
class ECODS_API NotUpdated final : public Error {
  public:
    NotUpdated();
};

// ShapeChanged is thrown by check_invariants() only, if the kind, box or digest of a caller's shape changed since a
// body got the shape.
class ECODS_API ShapeChanged final : public Error {
  public:
    ShapeChanged(BodyId body, ShapeKind kind, const std::string& what_changed);

    BodyId body;
    ShapeKind kind;
};

// ExecutorFailed is thrown if an Executor did not run each task once, or ran two tasks at the same time as the same
// worker.
class ECODS_API ExecutorFailed final : public Error {
  public:
    using Error::Error;
};

// TraceFailed is thrown by World::end_trace() only, if the stream failed while the world wrote the trace. The trace
// ends at that point.
class ECODS_API TraceFailed final : public Error {
  public:
    TraceFailed();
};

// InvalidTrace is thrown if a text is not a trace, or contains a call that a World refuses.
class ECODS_API InvalidTrace final : public Error {
  public:
    InvalidTrace(std::size_t line, const std::string& reason);

    std::size_t line;  // from 1
};

// BrokenInvariant is thrown by check_invariants() only, if an invariant does not hold: this library has a defect, or
// memory was overwritten.
class ECODS_API BrokenInvariant final : public Error {
  public:
    using Error::Error;
};

// Sets a function that is called before StaleBody, SameBody or MovedFromWorld is thrown, and returns the function set
// before. These errors are mistakes in the program, and a debugger or a log can show where they occur. By default
// nothing is called; null restores the default. May be called from any thread.
using MisuseHandler = void (*)(const Error&);
ECODS_API MisuseHandler set_misuse_handler(MisuseHandler handler) noexcept;

}  // namespace ecods
