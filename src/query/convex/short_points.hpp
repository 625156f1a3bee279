// Computes the points of two posed hulls as 128-bit integers, if the digits of matrices and vertices fit into 64 bits
// (ShortMatrix). Points that need more than 120 digits are rounded down, like those of IntegerFrame.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/pose.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/point/short_matrix.hpp"
#include "query/convex/support_points.hpp"

namespace ecods::convex {

class ShortPoints {
  public:
    // Returns true if the matrices fit; find() requires it. `reach` must be at least half of the largest magnitude of a
    // coordinate of b.t - a.t, and at most 2^100.
    bool bind(const Pose& a, const SupportPoints& points_a, const Pose& b, const SupportPoints& points_b,
              double reach) noexcept;

    // Computes the point of a vertex of the first (0) or second (1) hull, relative to a.t, in units of 2^unit().
    // Returns true if the digits of its coordinates fit. Magnitudes of points, and of differences of two points, are
    // below 2^122.
    bool find(std::size_t side, std::uint32_t vertex, exact::IntegerVector& point) noexcept;

    int unit() const noexcept { return unit_; }
    // True if all points found are exact. Otherwise products and a difference of translations, each rounded down by
    // less than a unit, leave the difference of two coordinates off by less than 3 units.
    bool is_exact() const noexcept { return lost_ == 0; }

  private:
    struct Body {
        const SupportPoints* points;
        exact::ShortMatrix R;
        exact::IntegerVector offset;  // t - t0
        int shift;                    // number of digits dropped from sums of products
        exact::Uint128 below;         // mask of the digits dropped
    };

    std::array<Body, 2> bodies_;
    int unit_ = 0;
    exact::Uint128 lost_ = 0;  // all digits that were dropped
};

}  // namespace ecods::convex
