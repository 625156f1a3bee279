// A plane through three vertices of a set of differences, in integers of 128 and 256 bits: how far it is from the
// origin and its unit normal, rounded once wherever that is certain.
//
// With IntegerFrame::is_exact() points are exact, and so are normals. Otherwise a coordinate of a difference m is off
// by less than 5 units, and one of an edge by 10. Points are below 2^122 and their differences below 2^123 in
// magnitude, so edges of the set of differences are below 2^124, and products of two below 2^249: 256 bits hold them.
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

    // Of three differences of vertices, counterclockwise from outside; a coordinate of them is a multiple of 2^unit.
    FixedPlane(const std::array<Vector, 3>& m, int unit, bool is_exact) noexcept;

    // The sign of the product of the normal with the difference of two points. Only of exact points.
    int sign_along(const Vector& v) const noexcept;

    // The sign of the distance, negative where the origin is beyond the plane; nothing where that is not certain.
    std::optional<int> side() const noexcept;

    // The distance, rounded, at least 2^-1074 if it is positive; nothing where its rounding is not certain. Not where
    // side() is not.
    std::optional<double> distance() const noexcept;
    // The unit normal, each coordinate rounded.
    std::optional<Vec3> direction() const noexcept;

    // The sign of how much further from the origin this plane is than another, neither of them on its outer side;
    // nothing where it is not certain.
    std::optional<int> compare(const FixedPlane& other) const noexcept;

  private:
    void find_normal() noexcept;
    void find_height() noexcept;
    std::optional<FixedDigits> quotient(exact::Uint128 size, exact::Uint128 error, int exponent) const noexcept;
    std::optional<FixedDigits> digits() const noexcept;  // of the distance

    std::array<Vector, 3> m_;
    int unit_;
    bool is_exact_;
    bool is_open_ = false;  // whether nothing is known of the normal
    int axis_ = -1;
    std::array<exact::Int256, 3> n_;          // the normal
    std::array<exact::Int128, 3> short_n_{};  // its leading digits: the largest has 126, off by less than error_
    exact::Uint128 error_ = 0;
    exact::Uint128 root_ = 0;  // 2^252 / |short_n_|, off by a part of 2^-94 at most
    exact::Int256 height_{};   // short_n_ . m
    exact::Int256 height_error_{};
};

}  // namespace ecods::exact
