// LinePoints computes the points of a posed mesh and the direction of a line as integers, relative to the line's
// beginning.
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

// LinePoints is used only if the digits of line and body fit into two limbs, as most do. A hit of a triangle then costs
// only the computation of the triangle's three points.
class LinePoints {
  public:
    using Point = TwoLimbKernel::Point;

    // Binds a body. Mesh and pose need not outlive the call.
    void bind(const BodyRef& body) noexcept;

    // Binds a line, and returns true if the digits of body and line fit. The functions below may be called only if the
    // last bind(line) returned true.
    bool bind(const Line& line) noexcept;

    // Returns true if each coordinate fits into one limb: all are below 2^OneLimbKernel::coordinate_bits.
    bool is_one_limb() const noexcept { return is_one_limb_; }

    // direction() returns the line's direction, and at(v) the point of vertex v, both in units of 2^unit().
    int unit() const noexcept { return unit_; }
    const Point& direction() const noexcept { return direction_; }
    Point at(const Vec3& v) const noexcept;

  private:
    PoseTerms terms_;  // with the offset t minus the line's beginning
    ShortProducts products_;
    Vec3 t_ = Vec3::Zero();
    BitRange digits_;  // digits of the products R_ij v_j
    Point offset_{};   // t minus the line's beginning, in units
    Point direction_{};
    int unit_ = 0;
    bool is_one_limb_ = false;
};

}  // namespace ecods::exact
