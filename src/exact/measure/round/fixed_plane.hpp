// A FixedPlane is a plane through three vertices of a Minkowski difference, in integers of 128 and 256 bits. Its
// distance from the origin and its unit normal are rounded once, if the rounding is certain.
//
// If IntegerFrame::is_exact(), points and normals are exact. Otherwise a coordinate of a difference m of two points is
// off by less than 5 units, and a coordinate of an edge by less than 10. Points are below 2^122 and their differences
// below 2^123 in magnitude. So edges of the Minkowski difference are below 2^124, and products of two edges below
// 2^249, which fit into 256 bits.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "exact/measure/round/fixed_digits.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

class FixedPlane {
  public:
    using Vector = exact::IntegerVector;

    // Computes the plane through the vertices `m` of the Minkowski difference, counterclockwise as seen from outside.
    // The coordinates of `m` are integers times 2^unit.
    FixedPlane(const std::array<Vector, 3>& m, int unit, bool is_exact) noexcept;

    // Returns the sign of the dot product of the normal and v, which is a difference of two points. Call this function
    // only if is_exact.
    int sign_along(const Vector& v) const noexcept;

    // Returns the sign of the distance, which is negative if the origin is on the plane's outer side; nullopt if the
    // sign is not certain.
    std::optional<int> side() const noexcept;

    // Returns the distance, rounded, and at least 2^-1074 if it is positive; nullopt if its rounding is not certain.
    // Call this function only if side() is certain.
    std::optional<double> distance() const noexcept;
    // Returns the unit normal, each coordinate rounded once; nullopt if a rounding is not certain.
    std::optional<Vec3> direction() const noexcept;

    // Returns 1, 0 or -1 if this plane's distance from the origin is greater than, equal to or less than the other
    // plane's; nullopt if the order is not certain. The origin must be on the inner side of both planes, and in
    // neither.
    std::optional<int> compare(const FixedPlane& other) const noexcept;

  private:
    void find_normal() noexcept;
    void find_height() noexcept;
    std::optional<FixedDigits> quotient(exact::Uint128 size, exact::Uint128 error, int exponent) const noexcept;
    std::optional<FixedDigits> digits() const noexcept;  // |distance| as an interval

    std::array<Vector, 3> m_;
    int unit_;
    bool is_exact_;
    bool is_open_ = false;  // true if nothing is known of the normal
    int axis_ = -1;
    std::array<exact::Int256, 3> n_;          // the normal
    std::array<exact::Int128, 3> short_n_{};  // 126 leading digits of n_; off by less than error_
    exact::Uint128 error_ = 0;
    exact::Uint128 root_ = 0;  // 2^252 / |short_n_|, with a relative error of at most 2^-94
    exact::Int256 height_{};   // short_n_ . m_[0]
    exact::Int256 height_error_{};
};

}  // namespace ecods::exact
