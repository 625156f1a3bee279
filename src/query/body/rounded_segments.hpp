// Answers the questions about two spheres or capsules in fixed precision, where that decides each answer: about as fast
// as in doubles, and the same answers as those of the search for closest triangles.
#pragma once

#include <optional>

#include "ecods/results.hpp"
#include "exact/measure/distance/closest_on_segments.hpp"
#include "exact/measure/round/fixed_vector.hpp"
#include "query/body/rounded_pair.hpp"

namespace ecods {

class RoundedSegments {
  public:
    // Returns nullopt unless both cores are meshes of one point or segment, which certainly share no point, and at
    // least one has a radius; or if fixed precision does not decide which features are closest.
    static std::optional<RoundedSegments> find(const CoreAndRadius& a, const CoreAndRadius& b) noexcept;

    // Return nullopt if a rounding is not certain. The distance is that of the cores less both radii, also if it is
    // negative.
    std::optional<double> signed_distance() const noexcept;
    std::optional<ClosestPoints> signed_closest() const noexcept;
    // Returns the unit vector from the first core's closest point to the second's.
    std::optional<Vec3> direction() const noexcept;

    // Returns the middle of the two points.
    std::optional<Vec3> middle() const noexcept;
    // True if no other points of the cores are as close.
    bool is_only() const noexcept { return at_.is_only; }

  private:
    RoundedSegments(const exact::ClosestOnSegments& at, const exact::FixedVector& w, int unit,
                    const exact::Radii& radii) noexcept
        : at_(at), w_(w), unit_(unit), radii_(radii) {}

    exact::ClosestOnSegments at_;
    exact::FixedVector w_;
    int unit_;
    exact::Radii radii_;
};

}  // namespace ecods
