// The points of a posed mesh and the direction of a line, as integers counted from the line's beginning.
#pragma once

#include <array>
#include <cstdint>

#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/point/frame.hpp"
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
    Point at(const Vec3& v) const noexcept { return is_short_ ? short_at(v) : long_at(v); }

  private:
    bool bind_differences(const std::array<Dyadic, 3>& a, const std::array<Dyadic, 3>& b, bool is_ray) noexcept;
    void set_unit(int low, int width) noexcept;
    Point short_at(const Vec3& v) const noexcept;
    Point long_at(const Vec3& v) const noexcept;

    std::array<std::array<Dyadic, 3>, 3> columns_{};  // of R
    std::array<Dyadic, 3> t_{};
    BitRange digits_, digits_of_t_;  // those of the products, and of t
    // Where all of R, and all vertices, are integers of 62 bits in units of their own: R, and these units.
    bool is_short_ = false;
    std::array<std::array<std::int64_t, 3>, 3> integers_{};  // by columns
    int unit_of_v_ = 0, unit_of_products_ = 0;
    Point offset_{};  // t less the line's beginning
    Point direction_{};
    int unit_ = 0;
    bool is_one_limb_ = false;
};

}  // namespace ecods::exact
