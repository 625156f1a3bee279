// The points of two posed hulls as integers of 128 bits, where the digits of matrices and of vertices fit into 64 bits
// (ShortMatrix). Points that need more than 120 digits are rounded down, as those of IntegerFrame are.
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
    // Returns whether matrices fit; only then may points be asked for. `reach` is at least half of the largest
    // magnitude of a coordinate of b.t - a.t, and ordinary: at most 2^100.
    bool bind(const Pose& a, const SupportPoints& points_a, const Pose& b, const SupportPoints& points_b,
              double reach) noexcept;

    // The point of a vertex of the first (0) or second (1) hull, in units of 2^unit(), relative to a.t. Returns whether
    // the digits of its coordinates fit. Magnitudes are below 2^122, and so are those of the differences of two points.
    bool find(std::size_t side, std::uint32_t vertex, exact::IntegerVector& point) noexcept;

    int unit() const noexcept { return unit_; }
    // Whether all points that were asked for are exact. Otherwise products and a difference of translations, each
    // rounded down by less than a unit, leave the difference of two coordinates off by less than 3 units.
    bool is_exact() const noexcept { return lost_ == 0; }

  private:
    struct Body {
        const SupportPoints* points;
        exact::ShortMatrix R;
        exact::IntegerVector offset;  // t - t0
        int shift;                    // of sums of products
        exact::Uint128 below;         // the digits that it cuts off
    };

    std::array<Body, 2> bodies_;
    int unit_ = 0;
    exact::Uint128 lost_ = 0;  // digits that were cut off
};

}  // namespace ecods::convex
