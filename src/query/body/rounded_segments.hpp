// Answers questions about two spheres or capsules, and about other rounded bodies with small convex cores, in fixed
// precision, if that suffices. This is about as fast as doubles, and gives the same answers as the search for the
// closest triangles.
#pragma once

#include <optional>

#include "ecods/results.hpp"
#include "exact/measure/distance/closest_on_segments.hpp"
#include "exact/measure/round/fixed_vector.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/convex/small_hulls.hpp"

namespace ecods {

class RoundedSegments {
  public:
    // Returns nullopt unless both cores are meshes of one point or segment, which certainly share no point, and at
    // least one has a radius; or if fixed precision does not decide which features are closest.
    static std::optional<RoundedSegments> find(const CoreAndRadius& a, const CoreAndRadius& b) noexcept;

    // Does the same for other cores, whose hulls must be small. Returns nullopt unless exactly one pair of points is
    // closest, inside features that are known. Two vertices or edges have the closest points of two segments; so have a
    // vertex and a face (exact/point/segment_ends.hpp).
    static std::optional<RoundedSegments> find_of_hulls(const CoreAndRadius& a, const CoreAndRadius& b,
                                                        convex::SmallHulls& hulls);

    // Return nullopt if a rounding is not certain. The distance is (distance of the cores) - (radii), also if it is
    // negative.
    std::optional<double> signed_distance() const noexcept;
    std::optional<ClosestPoints> signed_closest() const noexcept;
    // Returns adjacent doubles around the distance of the rounded bodies, or the distance twice if it is a double.
    std::optional<DistanceBounds> distance_bounds() const noexcept;
    // Returns the unit vector from the first core's closest point to the second's.
    std::optional<Vec3> direction() const noexcept;

    // Returns the middle of the two closest points.
    std::optional<Vec3> middle() const noexcept;
    // Returns true if no other points of the cores are as close.
    bool is_only() const noexcept { return at_.is_only; }

    // Names the features that contain the closest points.
    struct Names {
        ClosestKind kind = ClosestKind::vertex_vertex;
        Feature a, b;
    };
    const Names& names() const noexcept { return names_; }

  private:
    RoundedSegments(const exact::ClosestOnSegments& at, const exact::FixedVector& w, int unit,
                    const exact::Radii& radii, const Names& names) noexcept
        : at_(at), w_(w), unit_(unit), radii_(radii), names_(names) {}

    // A Gap is a number in units of 2^unit, with an error bound.
    struct Gap {
        exact::FixedNumber number;
        int unit;
    };
    Gap gap() const noexcept;  // (distance of the cores) - (radii)

    exact::ClosestOnSegments at_;
    exact::FixedVector w_;
    int unit_;
    exact::Radii radii_;
    Names names_;
};

}  // namespace ecods
