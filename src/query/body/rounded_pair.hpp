// Defines RoundedPair: two bodies, which may be rounded, as cores and radii.
#pragma once

#include <optional>

#include "ecods/pose.hpp"
#include "ecods/rounded.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "exact/number/long_vector.hpp"

namespace ecods {

class RoundedSegments;

struct CoreAndRadius {
    CoreAndRadius(const Posed<Rounded>& posed)
        : core(posed.what->core(), posed.pose), radius(posed.what->radius()), kind(posed.what->kind()) {}
    CoreAndRadius(const Posed<MeshShape>& posed) : core(*posed.what, posed.pose) {}

    Posed<MeshShape> core;
    double radius = 0;  // not -0
    ShapeKind kind = ShapeKind::mesh();
};

// A RoundedPair holds two rounded bodies, and computes the functions of rounded.hpp for them. All shapes and poses must
// outlive each call.
struct RoundedPair {
    exact::Radii radii() const noexcept { return {a.radius, b.radius}; }
    // Returns the sign of (distance of the cores) - (radii) - max_distance, -1 or 1, if doubles decide it; otherwise
    // nullopt.
    std::optional<int> filtered(double max_distance, const Ask& ask) const;

    // Adds a query that fixed precision has decided to the counts, and sets the witness to the triangles of `found`.
    static void count_found(const RoundedSegments& found, const Ask& ask);

    bool intersects(const Ask& ask) const;
    Relation relation(const Ask& ask) const;
    double distance(const Ask& ask) const;
    bool within(double max_distance, const Ask& ask) const;
    ClosestPoints closest(const Ask& ask) const;
    DistanceBounds distance_bounds(const DistanceTolerance& tolerance, const Ask& ask) const;
    SignedDistance signed_distance(const Ask& ask) const;
    std::optional<Depth> depth(const Ask& ask) const;
    // Returns the first contact at which the bodies are within `distance`, which must be finite and not negative;
    // nullopt if there is none up to max_time.
    std::optional<FirstContact> cast(const Vec3& motion, double distance, double max_time, const Ask& ask) const;
    // Returns the first contact of the bodies while they move straight to the poses end_a and end_b; nullopt if there
    // is none up to max_time.
    std::optional<FirstContact> cast_straight(const Pose& end_a, const Pose& end_b, double max_time,
                                              const Ask& ask) const;
    // Returns what cast() returns, for a motion that need not be a vector of doubles. `latest` must be from 0 to 1, and
    // the sum of the radii and `distance` positive.
    std::optional<FirstContact> cast_along(const exact::ScaledLongVector& motion, double distance, double latest,
                                           const Ask& ask) const;

    CoreAndRadius a, b;
};

}  // namespace ecods
