// Rounded shapes are all points within a radius of a core: spheres, capsules, and any mesh or solid with a margin
// around it. (FCL, Coal: Sphere, Capsule, a margin; Bullet: collision margin; Parry: round shapes; padding, swept
// spheres.)
//
//     auto ball = sphere(0.5);
//     auto bone = capsule({0, 0, 0}, {0, 0, 1}, 0.1);
//     auto padded = rounded(std::make_shared<ConvexSolid>(mesh), 0.01);
//     double gap = distance({ball, pose_a}, {padded, pose_b});
//
// A pose moves the core: the body is all points within the radius of the real points R v + t. The radius is a length of
// the world, which no pose turns, scales or shears; so the image of a ball is a ball at every pose.
//
// Two bodies with radii r and s, whose cores are at the real distance D, are apart if D > r + s, touch if D = r + s >
// 0, and share inner points if D < r + s. The sums are exact, as is the sum with a clearance or a distance that is
// asked about, and so is each decision: balls of radii 1 and 2^-60 meet at distance 1. A body with radius 0 is its
// core. Numbers are rounded once (distance.hpp).
//
// This table has the questions about a rounded body and any mesh, solid or rounded body, in either order; a World asks
// the same ones (world.hpp). In it, "convex" means that the core is a ConvexSolid, or a mesh of one triangle (a point,
// a segment, a triangle). A question that is not answered throws NotSupported, with both kinds, or there is no such
// function. The table of all kinds of bodies, half spaces included, is tested in verify/unit/query/kinds_test.
//
//     intersects, distance, within, closest, distance_bounds     answered
//     signed_distance                                            answered, unless the cores share a point and one is
//                                                                not convex
//     depth                                                      answered, if both are convex
//     closest, signed_distance, locate of a point                answered
//     hits; casts by a translation, also to a distance           answered
//     contact_point of a cast by a translation                   answered
//     casts of straight motions and turns                        answered, if both bodies are translated (see below),
//                                                                or have no radius
//     contact_patch (contact.hpp)                                answered, if both are convex
//     relation                                                   answered, if both are convex, or one is convex and the
//                                                                other has no radius; otherwise, see relation()
//     a World's lists, events, nearest, closest_pairs            answered; distances are signed if both are convex
//     a World's casts and meetings of straight motions           answered, if all bodies are as above, near or far;
//                                                                of turns, and meetings of translations, NotSupported
//     a World's bodies_containing                                answered
//     a World's depths                                           answered for convex bodies; others are left out
//     a World's relations                                        as relation(): set_relations refuses other rounded
//                                                                bodies
//     traces                                                     written and read
//     with a half space                                          solid.hpp
//     certificates, of two bodies and of a World                 no such function; NotSupported
//     triangles, close_features, entering, depth_along           no such function; NotSupported by a World
//
// Everything is defined for all finite poses, also singular ones, and for zero-area triangles. Threads are as in
// intersection.hpp. A question may throw std::bad_alloc where numbers need more than some hundred digits.
//
// Method: the search for the cores' distance, with its limits enlarged by the radii. Differences of a rational number
// and a root are rounded without cancellation; where digits do not decide, squares are compared. Two bodies whose
// cores are points, segments, triangles, or convex solids of at most 64 vertices take some tenths of a microsecond
// instead, unless they touch, their cores meet, or features tie: doubles decide if they share a point, and integers of
// 128 bits give numbers with proven bounds.
//
// Example: verify/examples/how_do_i, spheres_and_margins().
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/distance.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

namespace ecods {

// A Rounded is the set of all points within `radius` of a core.
class ECODS_API Rounded final : public Shape {
  public:
    // Throws InvalidArgument if the core is null, or the radius is negative, NaN or infinite.
    Rounded(std::shared_ptr<const MeshShape> core, double radius);
    ~Rounded() override;

    ShapeKind kind() const noexcept override { return kind_; }  // rounded_convex() if the core is convex, see above
    // Returns the core's box, reaching further by the radius on all sides, rounded outwards.
    Aabb box(const Pose& pose) const override;
    std::uint64_t digest() const noexcept override;

    // Answer as hit.hpp says of a solid: a line that begins inside, and not on the surface, hits there, with parameter
    // 0 and kind `inside`. For each part of the line that is in the body, all_hits() has at most one hit where the line
    // enters (`front`) and one where it leaves (`back`), and none between them; where the line only touches the body,
    // it has a hit of the kind `face`. A line that begins on the surface has its hit there. The feature is the core's
    // that is closest to the hit point; of several, the first by the order of ClosestPoints. No two hits have the same
    // real parameter. A World takes the rounded parameter as exact.
    //
    // Without a radius, the hits are those of the core. all_hits() throws NotSupported if all of this is true: the
    // radius is below some 2^-48 of the coordinates, the core is a solid that is not convex, and it must be decided if
    // a part of the line inside the core joins two hits. Cost: distances of parts of the line from the core, and some
    // tens of microseconds for each triangle that the line may be near first; for all_hits(), for each triangle that
    // the line may be near.
    bool answers(Question question) const noexcept override { return question == Question::hits; }
    std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const override;
    std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const override;
    std::optional<Hit> first_hit(const Segment& segment, const Pose& pose, const Ask& ask) const override;
    std::optional<Hit> first_hit(const Ray& ray, const Pose& pose, const Ask& ask) const override;

    const MeshShape& core() const noexcept { return *core_; }
    const std::shared_ptr<const MeshShape>& core_ptr() const noexcept { return core_; }
    double radius() const noexcept { return radius_; }

  private:
    std::shared_ptr<const MeshShape> core_;
    double radius_;
    ShapeKind kind_;
};

// Make a ball, and a capsule: all points within `radius` of a segment, whose ends may be equal. Throw InvalidArgument
// for a coordinate that is not finite, or a radius as above.
[[nodiscard]] ECODS_API std::shared_ptr<const Rounded> sphere(double radius, const Vec3& center = Vec3::Zero());
[[nodiscard]] ECODS_API std::shared_ptr<const Rounded> capsule(const Vec3& p, const Vec3& q, double radius);

// Makes a shape with a margin from a MeshShape, Solid or ConvexSolid, or from a Rounded, whose radius then grows.
// Throws InvalidArgument as above; NotSupported for a shape of the caller's own, and if the shape is rounded already
// and the sum of both radii is no double.
[[nodiscard]] ECODS_API std::shared_ptr<const Rounded> rounded(const std::shared_ptr<const Shape>& shape,
                                                               double radius);

// Return true if the bodies share a point; touching counts. Cost: that of within() of the cores.
[[nodiscard]] ECODS_API bool intersects(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API bool intersects(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API bool intersects(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask = {});

// Return the relation of the first body to the second. A body with a positive radius has an inside, so its relations
// are those of a solid (intersection.hpp): to another solid apart, touching, overlapping, inside, contains or equal; to
// a surface apart, touching, crossing or contains.
//
// Throw NotSupported, with both kinds, if inner points are shared and a body with a positive radius has a core that is
// not convex: whether it contains the other one is not decided. Cost: up to three within(); if inner points are shared,
// one more for each vertex of a body that may be inside the other.
[[nodiscard]] ECODS_API Relation relation(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API Relation relation(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API Relation relation(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask = {});

// Return the distance of the bodies, D - (r + s), rounded once; 0 exactly if they share a point. Cost: that of
// closest() of the cores.
[[nodiscard]] ECODS_API double distance(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API double distance(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API double distance(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask = {});

// Return true if the real distance is at most max_distance: if D <= r + s + max_distance. Infinity is allowed. Throw
// InvalidArgument if max_distance is negative or NaN.
[[nodiscard]] ECODS_API bool within(const Posed<Rounded>& a, const Posed<Rounded>& b, double max_distance,
                                    const Ask& ask = {});
[[nodiscard]] ECODS_API bool within(const Posed<Rounded>& a, const Posed<MeshShape>& b, double max_distance,
                                    const Ask& ask = {});
[[nodiscard]] ECODS_API bool within(const Posed<MeshShape>& a, const Posed<Rounded>& b, double max_distance,
                                    const Ask& ask = {});

// Return the closest points. Features and kind are those of the cores: `intersecting` and `contained` mean that the
// cores share a point; the points are then that point. Otherwise each point is the core's closest point, moved by the
// radius along the unit vector towards the other core's; so if the rounded bodies share inner points, each point is
// where its body reaches deepest into the other one along that vector. Each coordinate is rounded once.
[[nodiscard]] ECODS_API ClosestPoints closest(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API ClosestPoints closest(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API ClosestPoints closest(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask = {});

// Return an interval that contains the distance, as distance_bounds() of meshes does.
[[nodiscard]] ECODS_API DistanceBounds distance_bounds(const Posed<Rounded>& a, const Posed<Rounded>& b,
                                                       const DistanceTolerance& tolerance, const Ask& ask = {});
[[nodiscard]] ECODS_API DistanceBounds distance_bounds(const Posed<Rounded>& a, const Posed<MeshShape>& b,
                                                       const DistanceTolerance& tolerance, const Ask& ask = {});
[[nodiscard]] ECODS_API DistanceBounds distance_bounds(const Posed<MeshShape>& a, const Posed<Rounded>& b,
                                                       const DistanceTolerance& tolerance, const Ask& ask = {});

// Return the signed distance with points and direction, as for two convex solids (SignedDistance). It is (distance of
// the cores) - (sum of the radii); if the cores share a point, it is minus the sum of their depth and both radii.
//
// Let n be the direction. Features, kind and n are those of the cores. The point of a is its core's point plus radius
// times n, and the point of b is its core's point minus radius times n, whether or not the cores share a point. So
// point_b - point_a is the signed distance times n, as real numbers. A core without an inside (a point, a segment, a
// triangle) has the depth after which some plane parts the cores. Ties of directions are broken as Depth says, also of
// flat solids.
//
// Bodies may have cores that are not convex, as long as these share no point. If the number is then negative, its
// magnitude is a lower bound of the length of the shortest translation that parts the interiors: after a shorter one,
// the cores are still too near to each other. If cores share a point and one of them is not convex, NotSupported is
// thrown; depth_bounds() (solid.hpp) bounds the depth of the cores. Throw SingularPose if the cores share a point and
// one has a singular pose. Cost: that of closest(), or that of signed_distance() of the cores. The first question about
// a core that is a mesh of one triangle, and that shares a point with another core, makes a flat convex solid of it,
// which the core keeps: some microseconds, and about 6 kilobytes. Many threads may ask at once.
[[nodiscard]] ECODS_API SignedDistance signed_distance(const Posed<Rounded>& a, const Posed<Rounded>& b,
                                                       const Ask& ask = {});
[[nodiscard]] ECODS_API SignedDistance signed_distance(const Posed<Rounded>& a, const Posed<MeshShape>& b,
                                                       const Ask& ask = {});
[[nodiscard]] ECODS_API SignedDistance signed_distance(const Posed<MeshShape>& a, const Posed<Rounded>& b,
                                                       const Ask& ask = {});

// Return the depth of two convex bodies, which is minus their signed distance, and its direction; nullopt if they share
// no point. The features are those of signed_distance(), unless neither body has a radius and both are convex solids
// (solid.hpp). Throw NotSupported, with both kinds, if a body is not convex; errors and cost are otherwise those of
// signed_distance().
[[nodiscard]] ECODS_API std::optional<Depth> depth(const Posed<Rounded>& a, const Posed<Rounded>& b,
                                                   const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<Depth> depth(const Posed<Rounded>& a, const Posed<MeshShape>& b,
                                                   const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<Depth> depth(const Posed<MeshShape>& a, const Posed<Rounded>& b,
                                                   const Ask& ask = {});

// Return the first contact of a, translated by time times `motion`, with b, which stays (cast.hpp): the first time at
// which the cores are within the exact sum of the radii, rounded once. The kind and the features are those of the
// cores' closest points then, by the rule of FirstContact; at time 0, those of closest(). Without radii, the contact is
// that of the cores. Throw InvalidArgument if a coordinate of the motion is not finite, or max_time is negative or NaN.
// Cost: that of within() at the start and for some parts of the motion; for each pair of triangles that may be near
// first, about a tenth of a millisecond. A body that slides along another one at little more than the radii has many of
// them.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<Rounded>& a, const Vec3& motion,
                                                         const Posed<Rounded>& b, double max_time = 1,
                                                         const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<Rounded>& a, const Vec3& motion,
                                                         const Posed<MeshShape>& b, double max_time = 1,
                                                         const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion,
                                                         const Posed<Rounded>& b, double max_time = 1,
                                                         const Ask& ask = {});

// Return the first contact of two bodies that each move straight from one pose to another (cast.hpp), or in any way
// (pose.hpp), if each of them is translated. A body is translated if its matrix stays; if its core is one point, and
// it goes straight to any pose; or if its core is one point on the axis of its turn. One body is then translated beside
// the other, by an exact vector, and the contact is as above. Without radii, the contact is that of the cores, with the
// motions that the casts of meshes have. Throw NotSupported, with both kinds, if a body has a radius and one of the two
// is not translated: the times at which turning edges are at a distance are roots of polynomials of degree 6 and more.
// Throw InvalidArgument if a motion is not valid, or max_time is negative or NaN. Cost: that of a cast by a
// translation.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<Rounded>& a, const Moving<Rounded>& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<Rounded>& a, const Moving<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<Rounded>& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<Rounded>& a, const Motion& motion_of_a,
                                                         const Posed<Rounded>& b, const Motion& motion_of_b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<Rounded>& a, const Motion& motion_of_a,
                                                         const Posed<MeshShape>& b, const Motion& motion_of_b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Motion& motion_of_a,
                                                         const Posed<Rounded>& b, const Motion& motion_of_b,
                                                         double max_time = 1, const Ask& ask = {});

// ---- points
//
// All throw InvalidArgument unless the point is finite. Cost: that of one or two closest() of the point and the core.

// Returns the point of the body that is closest to the given one, and the core's feature (ClosestPoint). If the given
// point is inside the body, the distance is 0, `point` is the given point, and the feature is no_feature. If it is on
// the body's surface, `point` is the given point, and the feature is that of the core's closest point.
[[nodiscard]] ECODS_API ClosestPoint closest(const Eigen::Ref<const Vec3>& point, const Posed<Rounded>& body,
                                             const Ask& ask = {});

// Returns (distance of the point from the core) - (radius); inside a solid core, minus the sum of the distance from the
// core's surface and the radius. It is negative exactly inside the body; then its magnitude is the distance from the
// body's surface if the core is convex, and otherwise a lower bound of it.
[[nodiscard]] ECODS_API double signed_distance(const Eigen::Ref<const Vec3>& point, const Posed<Rounded>& body,
                                               const Ask& ask = {});

// Returns whether the point is inside, outside or on the surface, and there the feature of the core's closest point.
// A body without a radius is its core: a point of a surface is on it.
[[nodiscard]] ECODS_API Location locate(const Eigen::Ref<const Vec3>& point, const Posed<Rounded>& body,
                                        const Ask& ask = {});

}  // namespace ecods
