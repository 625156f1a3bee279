// RoundedSegments holds the closest points of two spheres, capsules or other rounded bodies with small convex cores, in
// fixed precision. Its functions return nullopt where this precision does not decide.
#pragma once

#include <optional>

#include "exact/measure/distance/fixed_closest.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/convex/small_hulls.hpp"

namespace ecods {

class RoundedSegments : public exact::FixedClosest {
  public:
    // Returns the closest points of two spheres or capsules. Returns nullopt unless both cores are meshes of one point
    // or segment, which certainly share no point, and at least one has a radius; or if fixed precision does not decide
    // which features are closest.
    static std::optional<RoundedSegments> find(const CoreAndRadius& a, const CoreAndRadius& b) noexcept;

    // Returns the closest points of bodies with other convex cores, whose hulls must be small. Returns nullopt unless
    // exactly one pair of points is closest, inside features that are known.
    static std::optional<RoundedSegments> find_of_hulls(const CoreAndRadius& a, const CoreAndRadius& b,
                                                        convex::SmallHulls& hulls);

  private:
    explicit RoundedSegments(const FixedClosest& found) noexcept : FixedClosest(found) {}
};

}  // namespace ecods
