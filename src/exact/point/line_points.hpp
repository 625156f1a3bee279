// The points of a posed mesh and the direction of a line, as integers counted from the line's beginning.
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

// For those lines and bodies whose digits fit into two limbs, which is most of them: what is asked of a triangle then
// costs its three points and no more.
class LinePoints {
  public:
    using Point = TwoLimbKernel::Point;

    // What depends on the body alone; mesh and pose may be elsewhere afterwards.
    void bind(const BodyRef& body) noexcept;

    // Returns whether the digits fit. Only then may anything be asked.
    bool bind(const Line& line) noexcept;

    // Whether one limb holds all of them: coordinates are below 2^OneLimbKernel::coordinate_bits.
    bool is_one_limb() const noexcept { return is_one_limb_; }

    // The direction, and the point of a vertex of the body's mesh, in units of 2^unit().
    int unit() const noexcept { return unit_; }
    const Point& direction() const noexcept { return direction_; }
    Point at(const Vec3& v) const noexcept;

  private:
    PoseTerms terms_;  // the offset is that of a line
    ShortProducts products_;
    Vec3 t_ = Vec3::Zero();
    BitRange digits_;  // of the products
    Point offset_{};   // t less the line's beginning
    Point direction_{};
    int unit_ = 0;
    bool is_one_limb_ = false;
};

}  // namespace ecods::exact
