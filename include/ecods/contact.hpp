// A contact patch says where two convex bodies touch, or would touch first: a normal, a distance or depth, and the
// corners of the region in which their surfaces face each other. (Physics engines: contact manifold; MuJoCo: multiccd;
// Coal: ContactPatch; Bullet: btPersistentManifold.)
//
//     ContactPatch patch = contact_patch({box, pose_a}, {floor, pose_b});
//     for (const PatchCorner& corner : patch.corners) push(corner.point_a, corner.point_b, corner.gap);
//
// Let n be the normal, from a to b. The support feature of a is the vertex, edge or face of its points furthest along
// n; the support feature of b is that of its points furthest against n. The patch is all pairs (x, y), x in the support
// feature of a and y in the support feature of b, for which y - x is parallel to n. Seen along n, it is the
// intersection of two convex polygons:
//
//  - if the bodies are apart, it is the set of all closest pairs;
//  - if they touch, it is the set of all common points;
//  - if they share inner points, it is the set of all pairs that the shortest translation brings together (Depth).
//
// It is never empty. Each corner is made by a pair of features: a vertex that is over a vertex, an edge or a face of
// the other body, or two edges that cross, seen along n. A vertex of a mesh that lies inside a side of the patch, and
// is no extreme point of it, is no corner. Numbers are those of the real points, rounded once, as in distance.hpp; none
// depends on the order of triangles, the witness, memory, instruction set or compiler.
//
// Support features are exact: of a box that is tilted against its floor by 2^-50, it is an edge or a vertex, so that a
// patch has one or two corners. PatchLimits::min_cos_squared takes faces that are tilted a bit, as physics engines do.
//
// Method: the question begins with distance() or depth(), whose features it takes. Signs of rounded points, and exact
// ones where these do not decide, find the pairs of features. Their order around the patch follows from the edges that
// they share.
//
// Example: verify/examples/how_do_i, contact_of_boxes().
// Example: verify/examples/how_do_i, ball_on_a_floor().
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/rounded.hpp"
#include "ecods/shape.hpp"
#include "ecods/turn.hpp"

namespace ecods {

// PatchLimits selects the corners that contact_patch() returns.
struct PatchLimits {
    // Limits the number of corners; 0 keeps all. Otherwise the corners are kept that contain the first one and span the
    // largest area, seen along the normal; of several such choices the lexicographically first, by their places in the
    // patch. If the limit is 2, the second corner is the one furthest from the first, across the normal. Decided
    // exactly.
    std::uint32_t max_corners = 0;

    // Sets the square of the cosine of the greatest angle between the normal and a face that counts as facing it; above
    // 0 and at most 1. If it is below 1, a support feature that is an edge or a vertex is replaced: by the face that
    // contains it, is within this angle and has the least angle (of ties the first); if there is none and it is a
    // vertex, by the edge at the vertex that is within this angle of the plane perpendicular to the normal, and has the
    // least angle. Decided exactly.
    double min_cos_squared = 1;

    // Limits the gap: corners with a greater gap are left out. The limit may be negative, but neither NaN nor
    // -infinity. Real gaps are compared.
    double max_gap = std::numeric_limits<double>::infinity();
};

// A corner of a patch is a point of each body. point_b - point_a = gap n, as real numbers; a negative gap is a depth.
// Points of a rounded body are on its surface. `middle` is the middle of both points.
struct PatchCorner {
    Vec3 point_a = Vec3::Zero(), point_b = Vec3::Zero(), middle = Vec3::Zero();
    double gap = 0;
    // a and b are the features of lowest dimension that contain the points, named as by closest() and
    // signed_distance(). A rounded body has those of its core; a half space has the face of triangle 0.
    Feature a, b;

    friend bool operator==(const PatchCorner&, const PatchCorner&) = default;
};

// A ContactPatch is the contact of two convex bodies.
//
// Corners are counterclockwise around the normal, seen from where it points to. The first is the one with the least
// gap; of ties the first by the order of ClosestPoints. Without a tilt all gaps are equal, so that the first corner has
// the points of signed_distance(). Exchanging the bodies reverses the normal and the order of the corners; the first
// corner follows from the same rule. If several normals have the same depth, another one of them may then be chosen.
struct ContactPatch {
    double distance = 0;         // as in SignedDistance: the distance, or minus the depth
    Vec3 normal = Vec3::Zero();  // unit vector from a to b; of bodies that touch or overlap, the direction of Depth
    std::vector<PatchCorner> corners;
    std::uint32_t corner_count = 0;  // before max_corners left some out

    friend bool operator==(const ContactPatch&, const ContactPatch&) = default;
};

// Returns the contact patch of two convex bodies: ConvexSolid, or Rounded with such a core, a point, a segment or a
// triangle (sphere, capsule), or one of them a HalfSpace. Of a rounded body, the patch is that of the core, with points
// that are the radius away along the normal, and gaps that are less by the radii.
//
// Starts from a witness, and leaves one, except with a half space. Throws NotSupported for other shapes, and for two
// half spaces; SingularPose; InvalidArgument for limits that are not allowed. Cost: that of distance() or depth(), one
// or two microseconds, and some tenths for each corner; some tens of microseconds where tilted features replace others,
// and some microseconds for each corner on a half space. To leave corners out by max_corners takes time with the square
// of their number: for 30, some tens of microseconds, or some hundred if many areas are nearly equal. (Coal:
// computeContactPatch.)
[[nodiscard]] ECODS_API ContactPatch contact_patch(const Posed<Shape>& a, const Posed<Shape>& b,
                                                   const PatchLimits& limits = {}, const Ask& ask = {});

// ---- depths with points, and along a direction

// DepthPoints has a depth, and the two points that its translation brings together: the points of the first corner of
// the patch, which signed_distance() gives, too. point_a - point_b = depth times direction, as real numbers. `a` and
// `b` are the features of lowest dimension that contain the points; `depth` names the features that define the normal.
struct DepthPoints {
    Depth depth;
    Feature a, b;
    Vec3 point_a = Vec3::Zero(), point_b = Vec3::Zero();

    friend bool operator==(const DepthPoints&, const DepthPoints&) = default;
};

// Returns depth() with its points; nullopt if the solids share no point. Leaves a witness. Throws SingularPose. Cost:
// that of depth(), and one or two microseconds.
[[nodiscard]] ECODS_API std::optional<DepthPoints> depth_points(const Posed<ConvexSolid>& a,
                                                                const Posed<ConvexSolid>& b, const Ask& ask = {});

// A DepthAlong says how far b must go along a direction until two convex solids share no inner points.
//
// After translating b by s times the direction, s >= 0, the interiors share no point if and only if s is at least the
// parameter: this is the exact number, rounded once, and so is the length, which is the parameter times the direction's
// length. Both are 0 exactly if the solids touch, even if b would go into a: their interiors share no point. At the
// parameter, the solids touch in a plane across the normal, which `a` and `b` name as in Depth; of several such planes
// the first, in Depth's order, is given. With a flat solid, b must go until such a plane has each solid on one side, as
// depth() says; of two flat solids that share a point and lie in one plane, both numbers are 0.
struct DepthAlong {
    double parameter = 0;
    double length = 0;
    Feature a, b;
    Vec3 normal = Vec3::Zero();  // unit vector, out of a; its product with the direction is positive if they overlap

    friend bool operator==(const DepthAlong&, const DepthAlong&) = default;
};

// Returns the depth along a direction of any length but 0; nullopt if the solids share no point. Throws InvalidArgument
// if a coordinate is not finite, or all are zero; SingularPose. Cost: some tens of microseconds for solids of some tens
// of faces, and more than proportional to the number of faces that the search visits: it works in integers alone, and
// neither starts from a witness nor leaves one.
[[nodiscard]] ECODS_API std::optional<DepthAlong> depth_along(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                                              const Vec3& direction, const Ask& ask = {});

// A ContactPoint says where two bodies first touch, and along which direction they come together there.
//
// `point` is the point that the features of the FirstContact share at its time, each coordinate rounded once: the
// vertex if one of the features is a vertex, otherwise the point where the two edges cross.
//
// `normal` is a unit vector from a to b, each coordinate rounded once: the limit, as time goes up to the contact, of
// the direction from the closest point of a's triangles at its feature to that of b's triangles at its feature. (A
// triangle is at a vertex or an edge if it has corners with its coordinates; zero-area triangles of solids are left
// out.) For a vertex and a face it is the face's normal, for two edges their cross product. For a vertex and an edge,
// or two vertices, it is a projection of the motion onto the directions that separate two of these triangles at the
// contact: the shortest one, of all pairs of triangles; among equal ones, that of the first pair. So a box that lands
// flat on a floor has the floor's normal, whatever the way.
//
// If several pairs of features touch first, the contact names one pair, and `point` and `normal` are those of that
// pair.
struct ContactPoint {
    Vec3 point = Vec3::Zero();
    std::optional<Vec3> normal;  // empty for a contact at time 0, and where the functions below say so

    friend bool operator==(const ContactPoint&, const ContactPoint&) = default;
};

// Returns the point and the normal of a contact that cast(a, motion, b) returned. For the kinds `intersecting` and
// `contained`, the point is that of closest(). Throws InvalidArgument; NotSupported if the contact is found to belong
// to other bodies or another motion, which is not always noticed. Cost: one or two microseconds for a vertex and a face
// or for two edges; otherwise a pass over both meshes, and some tens of microseconds for each pair of triangles at the
// features.
[[nodiscard]] ECODS_API ContactPoint contact_point(const Posed<MeshShape>& a, const Vec3& motion,
                                                   const Posed<MeshShape>& b, const FirstContact& contact,
                                                   const Ask& ask = {});

// Return the point and the normal of a contact that cast() of rounded bodies returned: of a ball that falls on a floor,
// for example. Let x and y be the closest points of the cores at the contact's features at its exact time, and r and s
// the radii. The point is (s x + r y) / (r + s), on the segment from x to y: the one point that both bodies share when
// they touch, or, at time 0, one of the points that they share. The normal is the unit vector from x to y. If cores
// share a point at time 0, the point is that of closest(). Without radii, the answer is that of the cores. Throw
// InvalidArgument; NotSupported for every contact that is not exactly the one that cast() returns for the two
// triangles. Cost: that of some pairs of features in integers, about a tenth of a millisecond.
[[nodiscard]] ECODS_API ContactPoint contact_point(const Posed<Rounded>& a, const Vec3& motion, const Posed<Rounded>& b,
                                                   const FirstContact& contact, const Ask& ask = {});
[[nodiscard]] ECODS_API ContactPoint contact_point(const Posed<Rounded>& a, const Vec3& motion,
                                                   const Posed<MeshShape>& b, const FirstContact& contact,
                                                   const Ask& ask = {});
[[nodiscard]] ECODS_API ContactPoint contact_point(const Posed<MeshShape>& a, const Vec3& motion,
                                                   const Posed<Rounded>& b, const FirstContact& contact,
                                                   const Ask& ask = {});

// Return the point and the normal of a contact that cast() of a turning body (turn.hpp), or of two bodies that move
// from pose to pose, returned. The time is the exact one, before it was rounded. For a vertex and a face, the normal is
// the face's normal at that time, to the side from which the vertex comes; for two edges, it is their cross product at
// that time, to the side from which they come: the limit, as time goes up to the contact, of the direction from one
// feature to the other. For a vertex and an edge, and for two vertices, the normal is empty: the direction in which
// these features come together depends on their velocities, whose squares are of higher degree than the exact decision
// supports. Errors are as above; NotSupported also if a way has no such leg. Cost: some hundred microseconds, mostly
// for the normal.
[[nodiscard]] ECODS_API ContactPoint contact_point(const Turning<MeshShape>& a, const Posed<MeshShape>& b,
                                                   const FirstContact& contact, const Ask& ask = {});
[[nodiscard]] ECODS_API ContactPoint contact_point(const Turning<MeshShape>& a, const Vec3& motion_of_b,
                                                   const Posed<MeshShape>& b, const FirstContact& contact,
                                                   const Ask& ask = {});
[[nodiscard]] ECODS_API ContactPoint contact_point(const Way<MeshShape>& a, const Posed<MeshShape>& b,
                                                   const WayContact& contact, const Ask& ask = {});
[[nodiscard]] ECODS_API ContactPoint contact_point(const Moving<MeshShape>& a, const Moving<MeshShape>& b,
                                                   const FirstContact& contact, const Ask& ask = {});

// ---- answers of a World

// A BodyPatch names two convex bodies that collide, and has their contact patch.
struct BodyPatch {
    BodyPair bodies;
    ContactPatch patch;

    friend bool operator==(const BodyPatch&, const BodyPatch&) = default;
};

}  // namespace ecods
