// Results are answers to questions about two bodies, a line, a point, or a World.
//
// Each number is the true number of the real points R v + t, rounded once to the nearest double (ties to even). A zero
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

// A Relation says how two sets of points meet, if they do. Two surfaces, or two triangles, are apart, touching or
// crossing. A surface and a solid are apart, touching or crossing, or the surface is inside (and the solid contains
// it). Two solids are in any relation but crossing.
enum class Relation : std::uint8_t {
    apart = 0,     // they share no point
    touching = 1,  // they share a point (one is enough), but are neither crossing nor overlapping
    // Two surfaces cross if two triangles that are not coplanar share a point of the relative interior of both. (The
    // relative interior of a segment is the open segment.) Coplanar triangles that overlap are touching. A surface and
    // a solid cross if the surface has points inside the solid, and points outside. A flat convex solid counts as a
    // surface of one triangle, which may be a polygon (shape.hpp).
    crossing = 2,
    overlapping = 3,  // solids share inner points, and neither contains the other
    inside = 4,       // the first is a proper subset of the second
    contains = 5,     // the second is a proper subset of the first
    equal = 6,        // they are the same set, whatever their triangles are
};

// A Feature is a vertex, an edge or a face of a mesh. It is named by a triangle that contains it, and by a corner of
// this triangle, 0, 1 or 2: a vertex is at the corner; an edge goes from the corner to the next one; for a face, the
// corner is 0. If several corners of the triangle name the feature, `corner` is the least of them. The kind `none` is
// no feature of the mesh: the point is inside the solid.
struct Feature {
    enum class Kind : std::uint8_t { vertex, edge, face, none };

    Kind kind = Kind::vertex;
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;

    friend bool operator==(const Feature&, const Feature&) = default;
};
inline constexpr Feature no_feature{Feature::Kind::none, ~std::uint32_t{0}, 0};  // a triangle index that no mesh has

// A ClosestKind names the kinds of the features that contain the closest points.
enum class ClosestKind : std::uint8_t { vertex_vertex, vertex_edge, vertex_face, edge_edge, intersecting, contained };

// ClosestPoints holds two closest points of two bodies, or of two triangles, and the features that contain them.
//
// The features are those of lowest dimension that contain the points: a vertex, the open edge, or the open face. If
// several pairs of features have exactly the least distance, the first pair is given: in the order of ClosestKind, then
// of triangle and corner of `a`, then of `b`; then the pair whose feature of `a` is the vertex. Two edges are given
// only if they are not parallel: parallel edges also have a vertex at the least distance. A side of a zero-area
// triangle is an edge if its ends differ. If the bodies share a point, the kind is `intersecting`. Both features are
// then the faces of the least pair of triangles that share a point; both points are the lexicographically least corner
// of the set that these two triangles share.
//
// If the bodies share a point and no two triangles do, the kind is `contained`: a part of one body is inside the other
// one, a solid. (A part is a maximal set of triangles that are connected by vertices.) Let T be the least triangle of
// such parts, of `a` if it has one, otherwise of `b`. The feature of T's body is then corner 0 of T, the other feature
// is no_feature, and both points are that corner.
//
// The features of two convex solids that are apart, at regular poses, are those of the sets, as solid.hpp names them.
struct ClosestPoints {
    double distance = 0;
    ClosestKind kind = ClosestKind::intersecting;
    Feature a, b;
    Vec3 point_a, point_b;

    TrianglePair triangles() const noexcept { return {a.triangle, b.triangle}; }
    friend bool operator==(const ClosestPoints&, const ClosestPoints&) = default;
};

// A ClosestPoint is the point of a body that is closest to a given point, and the feature that contains it. The feature
// is the one that ClosestPoints names for a body that is the given point alone.
//
// So if several features are at exactly the least distance, the first is given: vertices before edges and faces, then
// by triangle and corner. If the given point is on the body's surface, the distance is 0, `point` is the given point,
// and the feature is the face of the least triangle that contains it (locate() names the feature of lowest dimension).
// If the given point is inside a solid, the distance is 0, `point` is the given point, and the feature is no_feature.
struct ClosestPoint {
    double distance = 0;
    Feature feature;
    Vec3 point = Vec3::Zero();

    friend bool operator==(const ClosestPoint&, const ClosestPoint&) = default;
};

// DistanceBounds is an interval that contains a distance.
struct DistanceBounds {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
};

// A SharedSet is the set of points that two triangles share: a point (one corner), a segment (two), or a convex polygon
// in a common plane.
struct SharedSet {
    std::size_t corner_count = 0;  // 1 to 6; 0 if the triangles share no point

    // The corner whose real point is lexicographically least comes first. Other corners of a polygon follow
    // counterclockwise, seen from the side to which `normal` points; for a polygon, that is the first triangle's
    // normal.
    std::array<Vec3, 6> all_corners{};

    // `normal` is a unit vector in three cases; otherwise empty. (1) The shared set is inside one triangle's face, and
    // in a vertex or an edge of the other triangle: the face's normal, (q - p) x (r - p) of its corners p, q and r. (2)
    // It is in both faces: the first triangle's normal. (3) It is one point inside an edge of each, and these edges are
    // not parallel: the cross product of the first triangle's edge and the second's, each from its corner to the next
    // one. (If edges of a zero-area triangle lie on each other, the edge of the least corner counts.)
    std::optional<Vec3> normal;

    std::span<const Vec3> corners() const noexcept { return std::span(all_corners).first(corner_count); }
};

struct TriangleIntersection {
    TrianglePair triangles;
    SharedSet shared;
};

// CloseFeatures are two features that are near each other.
//
// The features are those of the meshes, whatever triangles name them: corners with equal coordinates are one vertex (-0
// equals 0), edges between the same two vertices are one edge, and each triangle has a face of its own. Each feature is
// named by the least triangle and corner of the whole mesh that name it.
struct CloseFeatures {
    // Holds the two features with their own distance and closest points. Features that touch have distance 0.
    ClosestPoints closest;

    // `direction` is a unit vector, or empty. If the distance is positive: the direction from the closest point of `a`
    // to that of `b`. If it is 0 and a vertex touches a face: the face's normal, (q - p) x (r - p) of its corners p, q
    // and r. If it is 0 and two edges touch: the cross product of the edge of `a` and the edge of `b`, each from the
    // corner that names it to the next one. Empty for all other kinds.
    std::optional<Vec3> direction;
};

// A FirstContact is the time at which two moving bodies first meet, and a pair of features that share a point then.
// (FCL: time of contact; Box3D: time of impact.)
//
// A pair of triangles counts if the time of its first contact rounds to `time`. Its features are those of lowest
// dimension that contain the shared point at this first contact. Of the features of all pairs that count, the first is
// given, in the order of ClosestPoints. At time 0 the kind is `intersecting`, and the features are the faces of the
// least pair of triangles that share a point at the start; or it is `contained`, with the features of ClosestPoints.
struct FirstContact {
    double time = 0;
    ClosestKind kind = ClosestKind::intersecting;
    Feature a, b;

    TrianglePair triangles() const noexcept { return {a.triangle, b.triangle}; }
    friend bool operator==(const FirstContact&, const FirstContact&) = default;
};

// A HitKind says how a line hits a triangle.
enum class HitKind : std::uint8_t {
    front,   // inside the face, coming from the side on which its posed corners are counterclockwise
    back,    // inside the face, from the other side
    face,    // inside the face, by a point that comes from no side: a segment of length 0, a ray in the face that ends
             // where it begins
    edge,    // at one point inside an edge
    vertex,  // at one point, a vertex
    along,   // at more than one point: a part of the line is in the triangle's plane, or on a zero-area triangle
    inside,  // no triangle: the line begins inside the solid. The parameter is 0, the feature is no_feature
};

// A Hit holds the points that a segment or ray shares with one triangle: one point, or all points from `point` to
// `leave_point`.
struct Hit {
    double parameter = 0;        // of the first shared point
    double leave_parameter = 0;  // of the last one; differs from `parameter` only if `along`
    HitKind kind = HitKind::front;
    // Counts the distinct smaller real parameters with a hit. Hits of equal rank tie exactly.
    std::uint32_t rank = 0;
    // Names the triangle's feature of lowest dimension that contains all shared points. Corners with equal coordinates
    // are one vertex. If a feature has several names in the triangle, that of the least corner is given.
    Feature feature;
    Vec3 point = Vec3::Zero();
    Vec3 leave_point = Vec3::Zero();

    std::uint32_t triangle() const noexcept { return feature.triangle; }
};

enum class Side : std::uint8_t { outside, on, inside };

// A Location says where a point is relative to a solid.
struct Location {
    Side side = Side::outside;

    // Names the vertex, open edge or open face that contains the point, if it is on the surface. Of several such
    // features, the one of lowest dimension is given, then the one of the least triangle and corner. Indices are those
    // of the mesh.
    Feature feature = {};

    friend bool operator==(const Location&, const Location&) = default;
};

// A Depth is the shortest translation of b that parts two convex solids (FCL, Coal: penetration depth).
//
// Its direction is an exact normal, which the features `a` and `b` name: `a` is the first solid's feature furthest
// along the normal, `b` the second solid's feature furthest against it; solid.hpp says how features are named. If `a`
// is a face, the normal is the outer normal of `a`. Otherwise, if `b` is a face, it is the inner normal of `b`.
// Otherwise both are edges that are not parallel, and it is their cross product, turned so that it points out of the
// first solid. Let n be the normal: translating b by any s with s . n >= depth |n|, for the real depth, parts the
// interiors.
//
// If several normals have exactly this depth, the first is given: faces of the first solid by their names, then faces
// of the second, then pairs of edges by the name of the first solid's edge and then of the second's.
//
// A polygon's face has an outer normal on both sides. If both normals have this depth, the other solid's features
// decide: a vertex before an edge before a face, then by name. If both solids are flat, and the vectors between their
// points lie in a plane, the depth is 0, and `a` and `b` each name the whole solid. Then the normal is (q - p) x (r -
// p) of the corners of the triangle that names the polygon `a`, or `b` if only that is a polygon. For two segments that
// are not parallel it is their cross product, each taken from the vertex of the lesser name. Otherwise it is the cross
// product of a segment and the first axis not parallel to it; or, for two points, x.
struct Depth {
    double depth = 0;  // 0 exactly when the solids touch, as two in one plane do
    Feature a, b;
    Vec3 direction = Vec3::Zero();  // the unit vector along the normal; b moves along it

    friend bool operator==(const Depth&, const Depth&) = default;
};

// ---- answers of a World

// A NearestBody is the body at the least distance from a subject, if the real distance is at most the limit. If rounded
// distances are equal, the least id is given.
//
// Cost: that of BroadPhase::visit_near; for each body visited that is not filtered out, a test of `within`, usually a
// cheap one; and a distance for each body that is the closest so far.
struct NearestBody {
    BodyId body;
    double distance = 0;

    friend bool operator==(const NearestBody&, const NearestBody&) = default;
};

// A ClosestPair says how far two bodies are from each other, and where they are closest. The distance is signed in
// three cases: both bodies are ConvexSolids at regular poses; at least one is rounded, and each body, or its core, is a
// ConvexSolid or a mesh of one triangle at a regular pose; or one is a half space and the other one a mesh, a solid or
// a rounded body. A signed distance is that of SignedDistance, so negative if they share inner points. For all other
// pairs the distance is that of World::distance, which is 0 if they share a point: for a mesh or a solid with dents and
// anything but a half space, for two half spaces, and for a caller's own shapes. `distance` is rounded once; a limit is
// compared with the real distance.
//
// `points` has that distance, the features and the points: those of SignedDistance, or of World::closest. It is empty
// for two half spaces, and for a caller's own shapes whose test does not answer `closest`. `direction` is that of
// SignedDistance, along which the second body would move; it is empty if the distance is positive or has no sign. Pairs
// are ordered by distance, then by ids.
struct ClosestPair {
    BodyPair bodies;
    double distance = 0;
    std::optional<ClosestPoints> points = {};
    std::optional<Vec3> direction = {};

    friend bool operator==(const ClosestPair&, const ClosestPair&) = default;
};

// A BodyHit is a hit and its body. `hit.rank` counts the smaller parameters of all bodies that were asked. Hits are
// ordered by real parameter, then by id, then by triangle. The parameters that a rounded body or a caller's own shape
// returns are taken as exact; hits of one such body with the same parameter keep the order in which it returned them.
//
// Cost: that of BroadPhase::visit_along, and a question to each body whose box the line meets before the first hit.
struct BodyHit {
    BodyId body;
    Hit hit;
};

// A BodyContact is the body that a moving subject meets first, if the exact time is at most max_time. Bodies are
// compared by their times, each rounded once; if times are equal, the least id is given. `contact.a` is a feature of
// the moving subject, `contact.b` of `body`.
//
// Cost: that of BroadPhase::visit_along, or for a turn of BroadPhase::find for each of some dozens of pieces; and a
// cast for each body whose box the way meets before the first contact.
struct BodyContact {
    BodyId body;
    FirstContact contact;

    friend bool operator==(const BodyContact&, const BodyContact&) = default;
};

// A Meeting is the first contact of two bodies while bodies move. `contact.a` is a feature of `bodies.a`. Meetings are
// ordered by first time, rounded once, then by pair. Pairs that meet at time 0 are included.
//
// Cost: near-linear in the numbers of bodies listed, of bodies changed since the last update, and of colliding pairs;
// and a cast for each pair of bodies whose swept boxes overlap. (A whole turn has one box.)
struct Meeting {
    BodyPair bodies;
    FirstContact contact;

    friend bool operator==(const Meeting&, const Meeting&) = default;
};

// A PairRelation names two bodies that collide, and the relation of the first to the second.
//
// Cost: at an update, one relation() for each pair that was tested and collides, and a pass over the list.
struct PairRelation {
    BodyPair bodies;
    Relation relation = Relation::touching;

    friend bool operator==(const PairRelation&, const PairRelation&) = default;
};

// A BodyDepth names two convex bodies that share a point, and the shortest translation of `bodies.b` that parts them.
// Cost: that of closest_pairs, and a depth() for each pair.
struct BodyDepth {
    BodyPair bodies;
    Depth depth;

    friend bool operator==(const BodyDepth&, const BodyDepth&) = default;
};

// A PairDistance names two bodies and their distance, signed as in ClosestPair. It costs what closest_pairs() does.
struct PairDistance {
    BodyPair bodies;
    double distance = 0;

    friend bool operator==(const PairDistance&, const PairDistance&) = default;
};

// A BodyAt names a body that contains a point, inside or on its surface.
struct BodyAt {
    BodyId body;
    Side side = Side::inside;

    friend bool operator==(const BodyAt&, const BodyAt&) = default;
};
struct BodiesContaining {
    std::vector<BodyAt> bodies;     // ascending
    std::size_t skipped_count = 0;  // bodies that were not asked: surfaces, half spaces, the caller's own
};

// ---- names

// Write a name: "apart", "vertex and face", "front", "outside", and so on.
ECODS_API std::ostream& operator<<(std::ostream& out, Relation relation);
ECODS_API std::ostream& operator<<(std::ostream& out, ClosestKind kind);
ECODS_API std::ostream& operator<<(std::ostream& out, HitKind kind);
ECODS_API std::ostream& operator<<(std::ostream& out, Side side);

}  // namespace ecods
