// ShortPoints computes the points of two posed hulls as 128-bit integers, if the digits of matrices and vertices fit
// into 64 bits (ShortMatrix). Points that need more than 120 digits are rounded down, as by IntegerFrame.
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
    // Returns true if the matrices fit; otherwise find() must not be called. `reach` must be at most 2^100, and at
    // least half of the largest magnitude of a coordinate of b.t - a.t.
    bool bind(const Pose& a, const SupportPoints& points_a, const Pose& b, const SupportPoints& points_b,
              double reach) noexcept;

    // Sets `point` to the point of a vertex of the first (0) or second (1) hull, relative to a.t, in units of 2^unit().
    // Returns true if the digits of the vertex fit; otherwise `point` is not valid. Magnitudes of points, and of
    // differences of two points, are below 2^122.
    bool find(std::size_t side, std::uint32_t vertex, exact::IntegerVector& point) noexcept;

    int unit() const noexcept { return unit_; }
    // Returns true if all points found so far are exact. Otherwise the difference of two coordinates is off by less
    // than 3 units, because products and a difference of translations are each rounded down by less than a unit.
    bool is_exact() const noexcept { return lost_ == 0; }

  private:
    struct Body {
        const SupportPoints* points;
        exact::ShortMatrix R;
        exact::IntegerVector offset;  // t - t0
        int shift;                    // number of digits dropped from sums of products
        exact::Uint128 below;         // mask of the dropped digits
    };

    std::array<Body, 2> bodies_;
    int unit_ = 0;
    exact::Uint128 lost_ = 0;  // union of all digits that were dropped
};

}  // namespace ecods::convex
