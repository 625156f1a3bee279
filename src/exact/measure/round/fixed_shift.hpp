// A FixedShift is the shortest vector from one flat feature to another, parallel one, in fixed precision: from a point
// to a point or a line, or between two parallel planes. A FixedShift also has the unit vector along itself and its
// length.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "exact/measure/round/fixed_vector.hpp"

namespace ecods::exact {

// Returns n x, for a coordinate n of a direction, in units of 2^-FixedVector::unit_digits. |x| must be below 2^125, and
// the error of n below 2^63.
FixedNumber times(const FixedNumber& n, const FixedNumber& x) noexcept;

class FixedShift {
  public:
    // The coordinates of u, v and w are differences of points, below 2^122, and each is off by at most `error` units,
    // below 2^20. Each function returns nullopt if the error of the direction is too large.

    // Returns the shift w between two points.
    static std::optional<FixedShift> of_vector(const IntegerVector& w, std::uint64_t error) noexcept;
    // Returns the part of w that is perpendicular to a line along u.
    static std::optional<FixedShift> across_line(const IntegerVector& u, const IntegerVector& w,
                                                 std::uint64_t error) noexcept;
    // Returns the part of w that is perpendicular to a plane along u and v.
    static std::optional<FixedShift> across_plane(const IntegerVector& u, const IntegerVector& v,
                                                  const IntegerVector& w, std::uint64_t error) noexcept;

    // Returns coordinate k of the vector, in the unit of points.
    const FixedNumber& operator[](std::size_t k) const noexcept { return shift_[k]; }
    // Returns coordinate k of a unit vector along the shift, in units of 2^-FixedVector::unit_digits. Between planes,
    // the unit vector has the direction of the cross product of u and v.
    const FixedNumber& direction(std::size_t k) const noexcept { return direction_[k]; }
    // Returns the dot product of the shift and the unit vector, which may be negative between planes.
    const FixedNumber& length() const noexcept { return length_; }

    // Negates the unit vector and the length.
    void turn() noexcept;
    // Makes the vector zero, exactly; the unit vector stays.
    void vanish() noexcept;

  private:
    FixedShift() = default;
    bool set_direction(const std::optional<FixedVector>& along) noexcept;
    FixedNumber product(const IntegerVector& w, std::uint64_t error) const noexcept;

    std::array<FixedNumber, 3> shift_, direction_;
    FixedNumber length_;
};

}  // namespace ecods::exact
