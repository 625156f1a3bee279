// What can go wrong, as types.
//
// Every error is thrown by the call that brought the bad input in, before anything has changed: the world,
// and every other object, is as it was. what() names the body, mesh element and value in full precision;
// the members give the same for programs.
//
// A failed allocation is std::bad_alloc, and an exception out of a caller's own shape or test passes through.
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

// The common base: catch this to catch them all.
class ECODS_API Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// A vertex coordinate is NaN or infinite.
class ECODS_API InvalidVertex final : public Error {
  public:
    InvalidVertex(std::size_t vertex, int axis, double value);

    std::size_t vertex;  // index in the vertex list
    int axis;            // 0 to 2
    double value;
};

// A triangle names a vertex that does not exist.
class ECODS_API InvalidIndex final : public Error {
  public:
    InvalidIndex(std::size_t triangle, int corner, std::size_t value, std::size_t vertex_count);

    std::size_t triangle;  // index in the triangle list
    int corner;            // 0 to 2
    std::size_t value;     // the index that is out of range
    std::size_t vertex_count;
};

// A mesh has no triangle. (It would have no point, and be disjoint from everything, which nobody means.)
class ECODS_API EmptyMesh final : public Error {
  public:
    EmptyMesh();
};

// Numbers in the caller's memory do not make whole vertices, or whole triangles (Mesh::create).
class ECODS_API InvalidLayout final : public Error {
  public:
    InvalidLayout(std::size_t count, std::size_t stride);

    std::size_t count;   // of numbers
    std::size_t stride;  // from one vertex, or one triangle, to the next
};

// A mesh has more vertices or triangles than 32-bit indices can name.
class ECODS_API MeshTooLarge final : public Error {
  public:
    MeshTooLarge(std::size_t vertex_count, std::size_t triangle_count);

    std::size_t vertex_count;
    std::size_t triangle_count;
};

// The triangles of a mesh that is to bound a solid are not closed: an end of this edge is the end of an odd number of
// edges along its line.
class ECODS_API NotClosed final : public Error {
  public:
    using Coordinates = std::array<double, 3>;

    NotClosed(std::size_t triangle, int corner, const std::array<std::size_t, 2>& vertices,
              const std::array<Coordinates, 2>& points);

    std::size_t triangle;                 // index in the triangle list
    int corner;                           // 0 to 2: the edge goes from this corner of the triangle to the next one
    std::array<std::size_t, 2> vertices;  // the indices of its ends
    std::array<Coordinates, 2> points;    // and their coordinates
};

// Two triangles of a mesh that is to bound a solid share a segment or more which is not a side of both.
class ECODS_API SelfIntersecting final : public Error {
  public:
    explicit SelfIntersecting(const TrianglePair& triangles);

    TrianglePair triangles;  // the lesser index first
};

// A mesh that is to bound a convex solid has a vertex beyond the plane of one of its triangles. The edge is one whose
// other triangle has that vertex, where there is such an edge (the solid has a dent along it); otherwise any edge.
class ECODS_API NotConvex final : public Error {
  public:
    NotConvex(std::size_t triangle, int corner, const std::array<std::size_t, 2>& vertices, std::size_t beyond);

    std::size_t triangle;                 // index in the triangle list
    int corner;                           // 0 to 2: the edge goes from this corner of the triangle to the next one
    std::array<std::size_t, 2> vertices;  // the indices of its ends
    std::size_t beyond;                   // the index of the vertex that is beyond the triangle's plane
};

// What is to be a convex solid has no inner points: its points lie in one plane, or there are none.
class ECODS_API NoInterior final : public Error {
  public:
    explicit NoInterior(std::size_t point_count);

    std::size_t point_count;
};

// Where in a list that was given the bad entry is; nothing where there was no list.
using ListIndex = std::optional<std::size_t>;

// An entry of a pose is NaN or infinite.
class ECODS_API InvalidPose final : public Error {
  public:
    // Row and column of the 3x4 matrix [R t]; column 3 is the translation. Row 3 is the last one of a 4x4 matrix, which
    // must be 0 0 0 1 (Pose::from_matrix).
    InvalidPose(int row, int column, double value, BodyId body = {}, ListIndex index = {});

    int row;
    int column;
    double value;
    BodyId body;  // null when the pose was not yet a body's
    ListIndex index;
};

// The matrix of a pose is singular, where a question needs inner points of the solid at it.
class ECODS_API SingularPose final : public Error {
  public:
    explicit SingularPose(int argument, BodyId body = {});

    int argument;  // 0: the pose of the first solid asked about; 1: that of the second
    BodyId body;   // the body, where a World was asked
};

// Two solids share no point, so there is no depth of one in the other.
class ECODS_API SolidsApart final : public Error {
  public:
    explicit SolidsApart(BodyId a = {}, BodyId b = {});

    BodyId a, b;  // the bodies, where a World was asked
};

// Two lists that belong together, entry by entry, have different lengths.
class ECODS_API LengthMismatch final : public Error {
  public:
    LengthMismatch(std::size_t body_count, std::size_t pose_count);

    std::size_t body_count;
    std::size_t pose_count;
};

// A null mesh, shape or test was given.
class ECODS_API NullArgument final : public Error {
  public:
    explicit NullArgument(const std::string& argument);
};

// An id that names no body of this world: null, of a destroyed body, or of another world.
class ECODS_API StaleBody final : public Error {
  public:
    explicit StaleBody(BodyId body, ListIndex index = {});

    BodyId body;
    ListIndex index;
};

// A world was asked that was moved from. It can be assigned to and destroyed, and has no body; every other call throws.
class ECODS_API MovedFromWorld final : public Error {
  public:
    MovedFromWorld();
};

// A body was to be made of a mesh and of a shape at once (BodyOptions).
class ECODS_API MeshAndShape final : public Error {
  public:
    MeshAndShape();
};

// One body was given where a pair was asked for.
class ECODS_API SameBody final : public Error {
  public:
    explicit SameBody(BodyId body);

    BodyId body;
};

// Two kinds of shape are in one world, and no test for the two is registered.
class ECODS_API MissingTest final : public Error {
  public:
    MissingTest(ShapeKind a, ShapeKind b);

    ShapeKind a;
    ShapeKind b;
};

// Two shapes were asked a question that the test of their kinds does not answer, a shape one that it does not answer
// itself (hits), or a shape cannot be used in this way.
class ECODS_API NotSupported final : public Error {
  public:
    NotSupported(Question question, ShapeKind a, ShapeKind b);
    using Error::Error;  // not about two shapes

    std::optional<Question> question = {};
    ShapeKind a = {};  // with `question`: the kinds, in the order in which their test is registered; of `hits` both are
    ShapeKind b = {};  // the shape's
};

// A box with a NaN or with a minimum above its maximum, out of a user-defined shape or as an argument.
class ECODS_API InvalidBox final : public Error {
  public:
    InvalidBox(ShapeKind kind, int axis, double min, double max, BodyId body = {}, ListIndex index = {});
    InvalidBox(int axis, double min, double max);  // an argument

    ShapeKind kind;  // of the shape that returned the box; mesh() if the box was an argument
    int axis;
    double min;
    double max;
    BodyId body;  // null when the shape was not yet a body's
    ListIndex index;
};

// An end of a segment has a coordinate that is NaN or infinite.
class ECODS_API InvalidSegment final : public Error {
  public:
    InvalidSegment(int end, int axis, double value);

    int end;   // 0 or 1
    int axis;  // 0 to 2
    double value;
};

// A ray has a coordinate that is NaN or infinite, no direction, or a largest parameter that is negative or NaN.
class ECODS_API InvalidRay final : public Error {
  public:
    enum class Part : std::uint8_t { origin, direction, parameter_max };

    // Of a direction of zero the axis is 0, as of a largest parameter.
    InvalidRay(Part part, int axis, double value);

    Part part;
    int axis;  // 0 to 2
    double value;
};

// A point has a coordinate that is NaN or infinite.
class ECODS_API InvalidPoint final : public Error {
  public:
    InvalidPoint(int axis, double value);

    int axis;  // 0 to 2
    double value;
};

// A motion has a coordinate that is NaN or infinite.
class ECODS_API InvalidMotion final : public Error {
  public:
    InvalidMotion(int axis, double value);

    int axis;  // 0 to 2
    double value;
};

// The center of a ball has a coordinate that is NaN or infinite, or its radius is NaN or negative.
class ECODS_API InvalidBall final : public Error {
  public:
    InvalidBall(int axis, double value);

    int axis;  // 0 to 2; 3 for the radius
    double value;
};

// A distance that was given is negative or NaN, or infinite where it must not be.
class ECODS_API InvalidDistance final : public Error {
  public:
    explicit InvalidDistance(double value);

    double value;
};

// A limit of time that was given is negative or NaN.
class ECODS_API InvalidTime final : public Error {
  public:
    explicit InvalidTime(double value);

    double value;
};

// A world changed since its last update, of which a certificate was asked.
class ECODS_API NotUpdated final : public Error {
  public:
    NotUpdated();
};

// A body's shape is of a kind of the caller's own, of which there are no certificates.
class ECODS_API NotCertified final : public Error {
  public:
    NotCertified(BodyId body, ShapeKind kind);
    BodyId body;
    ShapeKind kind;
};

// A user-defined shape is not what it was when its body got it: its box or digest changed. Thrown by validate() only.
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

// An invariant does not hold: a defect in this library, or memory overwritten. Thrown by validate() only.
class ECODS_API BrokenInvariant final : public Error {
  public:
    using Error::Error;
};

// Called before StaleBody, SameBody or MovedFromWorld, mistakes that are a program's own, is thrown, so that a
// debugger or a log sees the place. The default does nothing. Returns the handler that was set before. Setting
// it is safe from any thread; null restores the default.
using MisuseHandler = void (*)(const Error&);
ECODS_API MisuseHandler set_misuse_handler(MisuseHandler handler) noexcept;

}  // namespace ecods
