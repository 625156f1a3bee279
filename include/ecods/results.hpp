// The answers to questions: about two bodies, a line, a point, and a World.
//
// Numbers are the true ones of the real points R v + t, each rounded once to the nearest double (ties to even); a zero
// coordinate is +0. distance.hpp says more.
//
// Example: verify/examples/how_do_i, distance_with_points().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// The relation of two sets of points. Two surfaces (and two triangles) are apart, touching or crossing; a surface and a
// solid are apart, touching, crossing or inside; two solids are anything but crossing.
enum class Relation : std::uint8_t {
    apart = 0,     // they share no point
    touching = 1,  // they share a point, but are neither crossing nor overlapping. One common point suffices
    // Two surfaces cross if two triangles that are not coplanar share a point in the relative interior of both (of a
    // segment: the open segment). Coplanar triangles that overlap are touching. A surface and a solid cross if the
    // surface has points inside the solid, and points outside.
    crossing = 2,
    overlapping = 3,  // solids share inner points, and neither contains the other
    inside = 4,       // the first is a subset of the second, and not equal to it
    contains = 5,     // the second is a subset of the first, and not equal to it
    equal = 6,        // they are one set, whatever the triangles
};

// A vertex, an edge or a face of a mesh, named by a triangle that it is part of and the least corner of that triangle
// which names it: corner 0, 1 or 2 is the vertex; the edge goes from `corner` to the next one; of a face it is 0.
struct Feature {
    enum class Kind : std::uint8_t { vertex, edge, face };

    Kind kind = Kind::vertex;
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;

    friend bool operator==(const Feature&, const Feature&) = default;
};

// Which features hold the closest points.
enum class ClosestKind : std::uint8_t { vertex_vertex, vertex_edge, vertex_face, edge_edge, intersecting };

// Two closest points of two bodies, or of a triangle of each, and the features that hold them.
//
// The features are those of lowest dimension that hold the points: a vertex, the open edge, or the open face. Where
// several pairs of features have exactly that distance, the first is given: by kind in the order of ClosestKind, then
// by the triangle and corner of `a`, then of `b`, then the one whose feature of `a` is the vertex. Edges meet inside
// both where they are not parallel; parallel ones have a vertex at the least distance. An edge of a zero-area triangle
// is one if its ends differ. `intersecting`: the bodies share a point. Then both features are faces, of the least pair
// of triangles that share a point, and both points are the lexicographically least corner of what these two share.
struct ClosestPoints {
    double distance = 0;
    ClosestKind kind = ClosestKind::intersecting;
    Feature a, b;
    Vec3 point_a, point_b;

    TrianglePair triangles() const noexcept { return {a.triangle, b.triangle}; }
};

// An interval that holds a distance.
struct DistanceBounds {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
};

// The points that two triangles share: a point (one corner), a segment (two), or a convex polygon of a common plane.
struct SharedSet {
    std::size_t corner_count = 0;  // 1 to 6; 0 if they share nothing

    // The lexicographically least of the real points comes first. A polygon's others follow counterclockwise as seen
    // from where `normal` points to, which is the first triangle's.
    std::array<Vec3, 6> all_corners{};

    // A unit vector. The shared set is inside one face, and in a vertex or an edge of the other triangle: that face's
    // normal, (q - p) x (r - p) of its corners p, q and r. It is in both faces: the first triangle's normal. It is one
    // point inside an edge of each, not parallel: the product of the first triangle's edge and the second's, each from
    // its corner to the next one; of edges of a zero-area triangle that lie on each other, that of the least corner
    // counts. Otherwise empty: a vertex meets a vertex or an edge, edges lie along each other, or the triangles cross.
    std::optional<Vec3> normal;

    std::span<const Vec3> corners() const noexcept { return std::span(all_corners).first(corner_count); }
};

struct TriangleIntersection {
    TrianglePair triangles;
    SharedSet shared;
};

// Two features that are near each other.
//
// Vertices, edges and faces are those of the meshes, whatever triangles they are named by: corners at equal coordinates
// are one vertex (-0 is 0), edges between the same two vertices are one edge, and a face is that of its own triangle.
// Each is named by the least triangle and corner of the whole mesh that name it.
struct CloseFeatures {
    // The two features with their own distance and closest points. Features that touch have distance 0.
    ClosestPoints closest;

    // A unit vector. At a positive distance it is that from the closest point of `a` to that of `b`. At distance 0 it
    // is the normal, (q - p) x (r - p) of the corners p, q and r of the face, where a vertex touches one; the product
    // of the edge of `a` and that of `b`, each from the corner that names it to the next one, where two edges touch;
    // and empty for all other kinds.
    std::optional<Vec3> direction;
};

// The first contact of two bodies on their way, and the first pair of features, in the order of ClosestPoints, of those
// that share a point at a time that rounds to it. (FCL: time of contact; Box3D: time of impact.)
//
// A pair of triangles counts if its first time rounds to `time`. Its features are those of lowest dimension that hold
// the shared point at that first time. At time 0 the kind is `intersecting`: the features are both faces, of the least
// pair of triangles that share a point at the start.
struct FirstContact {
    double time = 0;
    ClosestKind kind = ClosestKind::intersecting;
    Feature a, b;

    TrianglePair triangles() const noexcept { return {a.triangle, b.triangle}; }
    friend bool operator==(const FirstContact&, const FirstContact&) = default;
};

// How a line hits a triangle.
enum class HitKind : std::uint8_t {
    front,   // inside the face, coming from the side from which its posed corners are counterclockwise
    back,    // inside the face, from the other side
    face,    // inside the face, by a point that comes from no side: a segment of length 0, a ray in the face that ends
             // where it begins
    edge,    // at one point inside an edge
    vertex,  // at one point, a vertex
    along,   // at more than one point: a part of the line lies in the triangle's plane, or on a zero-area triangle
};

// The points that a segment or ray shares with one triangle: one point, or all points from `point` to `leave_point`.
struct Hit {
    double parameter = 0;        // of the first shared point
    double leave_parameter = 0;  // of the last one: the same unless `along`
    HitKind kind = HitKind::front;
    // The number of distinct smaller real parameters with a hit. Hits of equal rank are exact ties, whatever their
    // rounded parameters.
    std::uint32_t rank = 0;
    // The feature of lowest dimension of this triangle that holds all shared points. Corners at equal coordinates are
    // one vertex; what has several names in the triangle has that of the least corner.
    Feature feature;
    Vec3 point = Vec3::Zero();
    Vec3 leave_point = Vec3::Zero();

    std::uint32_t triangle() const noexcept { return feature.triangle; }
};

enum class Side : std::uint8_t { outside, on, inside };

// The place of a point with respect to a solid.
struct Location {
    Side side = Side::outside;

    // The vertex, open edge or open face that holds the point, if the point is on the surface: of several, the feature
    // of lowest dimension, then of the least triangle and corner. Its indices are those of the mesh.
    Feature feature = {};

    friend bool operator==(const Location&, const Location&) = default;
};

// The shortest translation of b that parts two convex solids (FCL, Coal: penetration depth).
//
// Its direction is that of an exact normal, which `a` and `b` name: `a` is the feature of the first solid furthest
// along it, `b` the feature of the second furthest against it, vertices, edges or faces as solid.hpp names them. If `a`
// is a face, the normal is its outer one; otherwise, if `b` is a face, its inner one; otherwise both are edges that are
// not parallel, and it is their product, turned so that it goes out of the first solid. Let n be the normal:
// translating b by any s with s . n >= depth |n|, for the real depth, parts the interiors.
//
// Where several normals give exactly that depth, the first is given: faces of the first solid by their names, then
// faces of the second, then pairs of edges by the name of the first's and then of the second's.
struct Depth {
    double depth = 0;  // 0 exactly when the solids touch
    Feature a, b;
    Vec3 direction = Vec3::Zero();  // the unit vector along the normal; b moves along it

    friend bool operator==(const Depth&, const Depth&) = default;
};

// Proven bounds of the depth of two solids, convex or not: of the length of the shortest translation of one of them
// after which their interiors share no point.
//
// Upper bound: with its pose's translation replaced by `parted`, b shares no inner point with a, as solid_relation()
// says, and `upper` is |parted - b.pose.t|, rounded up. Lower bound: from a ball in each solid, so that shorter
// translations leave their interiors meeting; for convex solids, depth() rounded down. 0 and 0 where the solids touch.
// Both bounds hold; how narrow they are is not promised, and they may differ between versions. Along a direction that
// is tried, `upper` is the length of the way out to some 2^-46 of it, and to 2^-48 of the smaller solid's size, however
// large the other one is. `parted` is made of doubles: where the spacing of these at the pose's translation is more
// than the depth, so is `upper`, and it is infinite where none parts the solids.
struct DepthBounds {
    double lower = 0;
    double upper = 0;
    Vec3 parted = Vec3::Zero();
};

// ---- answers of a World

// NearestBody is the body at the least distance from a subject, ClosestPair the two bodies at the least distance from
// each other, if the real distance is at most the limit. Ties of rounded distances go to the least id or pair.
//
// Cost: that of BroadPhase::visit_near or visit_near_pairs; for each body or pair visited that is not filtered out a
// test of `within`, mostly a cheap one, and a distance where that is the least so far.
struct NearestBody {
    BodyId body;
    double distance = 0;

    friend bool operator==(const NearestBody&, const NearestBody&) = default;
};
struct ClosestPair {
    BodyPair bodies;
    double distance = 0;

    friend bool operator==(const ClosestPair&, const ClosestPair&) = default;
};

// A hit and its body. `hit.rank` counts the smaller parameters of all bodies that were asked. Hits are in the order of
// the real parameters, then of the ids, then of the triangles; the parameters that a shape of the caller's own gives
// count as they are.
//
// Cost: that of BroadPhase::visit_along, and a question to each body whose box is met up to the first hit.
struct BodyHit {
    BodyId body;
    Hit hit;
};

// The body met first by one on the move, if the real time is at most the limit; of equal times, each rounded once, the
// least id. `contact.a` is a feature of the body on the move, `contact.b` of this one.
struct BodyContact {
    BodyId body;
    FirstContact contact;

    friend bool operator==(const BodyContact&, const BodyContact&) = default;
};

// Two bodies that meet while bodies move: `contact.a` is a feature of `bodies.a`. Meetings are ordered by first time,
// rounded once, then by pair. Pairs that meet at time 0 are among them.
//
// Cost: near-linear in the bodies listed, those that changed since the last update and the colliding pairs, and a
// question for each two bodies whose ways' boxes overlap.
struct Meeting {
    BodyPair bodies;
    FirstContact contact;

    friend bool operator==(const Meeting&, const Meeting&) = default;
};

// Two bodies that are solids and share a point, and how the first is to the second: pairs whose surfaces collide, and
// pairs of which one is inside the other.
//
// Cost: at an update one solid_relation() for each pair of solids that was tested, and a pass over the list.
struct SolidPair {
    BodyPair bodies;
    Relation relation = Relation::touching;

    friend bool operator==(const SolidPair&, const SolidPair&) = default;
};

// Two bodies that are convex solids and share a point, and the shortest way out of `bodies.b`.
//
// Cost: a pass over the bodies, sorting the boxes of convex solids into trees, and a depth() for each pair that shares
// a point.
struct BodyDepth {
    BodyPair bodies;
    Depth depth;

    friend bool operator==(const BodyDepth&, const BodyDepth&) = default;
};

// Two bodies that are convex solids, and their distance: 0 exactly where they share a point.
//
// Cost: as of BodyDepth, and a solid_distance() for each pair whose boxes are not proven to be further apart than the
// limit.
struct SolidDistance {
    BodyPair bodies;
    double distance = 0;

    friend bool operator==(const SolidDistance&, const SolidDistance&) = default;
};

// A body that holds a point, inside or on its surface.
struct BodyAt {
    BodyId body;
    Side side = Side::inside;

    friend bool operator==(const BodyAt&, const BodyAt&) = default;
};
struct BodiesContaining {
    std::vector<BodyAt> bodies;     // ascending
    std::size_t skipped_count = 0;  // bodies of the world that are no solids, about which nothing is known
};

// ---- names

// "apart", "vertex and face", "front", "outside", and so on.
ECODS_API std::ostream& operator<<(std::ostream& out, Relation relation);
ECODS_API std::ostream& operator<<(std::ostream& out, ClosestKind kind);
ECODS_API std::ostream& operator<<(std::ostream& out, HitKind kind);
ECODS_API std::ostream& operator<<(std::ostream& out, Side side);

}  // namespace ecods
