// LinePoints are the points of a posed mesh and the direction of a line, as integers relative to the line's beginning.
#pragma once

#include <array>
#include <cstdint>

#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/point/pose_terms.hpp"
#include "exact/point/posed_points.hpp"
#include "exact/point/short_matrix.hpp"
#include "geometry/line.hpp"

namespace ecods::exact {

// Serves lines and bodies whose digits fit into two limbs, which most do: a question about a triangle then costs its
// three points and no more.
class LinePoints {
  public:
    using Point = TwoLimbKernel::Point;

    // Binds what depends on the body alone; mesh and pose may be elsewhere afterwards.
    void bind(const BodyRef& body) noexcept;

    // Returns true if the digits fit; the functions below may be called only then.
    bool bind(const Line& line) noexcept;

    // True if one limb holds each coordinate: all are below 2^OneLimbKernel::coordinate_bits.
    bool is_one_limb() const noexcept { return is_one_limb_; }

    // direction() and at() are the line's direction and the point of a vertex, in units of 2^unit().
    int unit() const noexcept { return unit_; }
    const Point& direction() const noexcept { return direction_; }
    Point at(const Vec3& v) const noexcept;

  private:
    PoseTerms terms_;  // its offset is t less the line's beginning
    ShortProducts products_;
    Vec3 t_ = Vec3::Zero();
    BitRange digits_;  // digits of the products
    Point offset_{};   // t less the line's beginning
    Point direction_{};
    int unit_ = 0;
    bool is_one_limb_ = false;
};

}  // namespace ecods::exact
