// A SmallPair holds two rounded bodies whose distance doubles and fixed precision decide in most cases: spheres,
// capsules, and other bodies with small convex cores. At least one body must have a radius.
#pragma once

#include <optional>

#include "query/body/rounded_pair.hpp"
#include "query/body/rounded_segments.hpp"
#include "query/convex/small_hulls.hpp"

namespace ecods {

class SmallPair {
  public:
    // The pair must outlive this object.
    explicit SmallPair(const RoundedPair& pair) noexcept;

    // Returns the sign of (distance of the cores) - (radii) - max_distance, -1 or 1, if doubles decide it; otherwise
    // nullopt.
    std::optional<int> compare(double max_distance) noexcept;
    // Returns the closest points if fixed precision decides on which features they are; otherwise nullopt. Continues
    // from the result of compare().
    std::optional<RoundedSegments> find_closest();

  private:
    const RoundedPair& pair_;
    bool are_segments_ = false;
    std::optional<convex::SmallHulls> hulls_;
};

}  // namespace ecods
