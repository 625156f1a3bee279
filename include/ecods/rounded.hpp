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
// The questions, for a rounded body and any mesh, solid or rounded body; a World asks the same ones (world.hpp). In
// this table, "convex" means that the core is a ConvexSolid, or a mesh of one triangle (a point, a segment, a
// triangle).
//
//     intersects, distance, within, closest, distance_bounds     answered
//     a World's lists, events, nearest, closest_pair             answered
//     relation                                                   answered, if both are convex, or one is convex and the
//                                                                other has no radius; otherwise, see relation()
//     a World's relations                                        as relation(): set_relations refuses other rounded
//                                                                bodies
//     traces                                                     written and read
//     with a half space                                          half_space.hpp
//     hits, casts, meetings, depth, certificates, triangles      NotSupported, or no such function
//
// Everything is defined for all finite poses, also singular ones, and for zero-area triangles. Threads are as in
// intersection.hpp. A question may throw std::bad_alloc where numbers need more than some hundred digits.
//
// Method: the search for the cores' distance, with its limits enlarged by the radii. Differences of a rational number
// and a root are rounded without cancellation; where digits do not decide, squares are compared.
//
// Example: verify/examples/how_do_i, spheres_and_margins().
#pragma once

#include <cstdint>
#include <memory>

#include "ecods/ask.hpp"
#include "ecods/distance.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// All points within `radius` of a core.
class ECODS_API Rounded final : public Shape {
  public:
    // Throws InvalidArgument if the core is null, or the radius is negative, NaN or infinite.
    Rounded(std::shared_ptr<const MeshShape> core, double radius);
    ~Rounded() override;

    ShapeKind kind() const noexcept override { return kind_; }  // rounded_convex() if the core is convex, see above
    // Returns the core's box, reaching further by the radius on all sides, rounded outwards.
    Aabb box(const Pose& pose) const override;
    std::uint64_t digest() const noexcept override;

    const MeshShape& core() const noexcept { return *core_; }
    const std::shared_ptr<const MeshShape>& core_ptr() const noexcept { return core_; }
    double radius() const noexcept { return radius_; }

  private:
    std::shared_ptr<const MeshShape> core_;
    double radius_;
    ShapeKind kind_;
};

// Make a ball, and all points within `radius` of a segment, whose ends may be equal. Throw InvalidArgument for a
// coordinate that is not finite, or a radius as above.
[[nodiscard]] ECODS_API std::shared_ptr<const Rounded> sphere(double radius, const Vec3& center = Vec3::Zero());
[[nodiscard]] ECODS_API std::shared_ptr<const Rounded> capsule(const Vec3& p, const Vec3& q, double radius);

// Makes a shape with a margin: of a MeshShape, Solid or ConvexSolid, or of a Rounded, whose radius then grows. Throws
// InvalidArgument as above; NotSupported for a shape of the caller's own, and if the shape is rounded already and the
// sum of both radii is no double.
[[nodiscard]] ECODS_API std::shared_ptr<const Rounded> rounded(const std::shared_ptr<const Shape>& shape,
                                                               double radius);

// Return true if the bodies share a point; touching counts. Cost: that of within() of the cores.
[[nodiscard]] ECODS_API bool intersects(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API bool intersects(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API bool intersects(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask = {});

// Return how the first body is to the second. A body with a positive radius has an inside, so it is as a solid is
// (intersection.hpp): apart, touching, overlapping, inside, contains or equal to another solid; and of a surface,
// apart, touching, crossing or containing it.
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

}  // namespace ecods
