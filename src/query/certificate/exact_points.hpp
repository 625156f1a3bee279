// Posed vertices and points of a segment as integers of any length, all counted in one power of two.
#pragma once

#include <array>
#include <span>

#include "ecods/segment.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/integer.hpp"
#include "exact/point/frame.hpp"

namespace ecods {

using IntegerVector3 = std::array<exact::Integer, 3>;

IntegerVector3 minus(const IntegerVector3& a, const IntegerVector3& b);
IntegerVector3 cross(const IntegerVector3& a, const IntegerVector3& b);
exact::Integer dot(const IntegerVector3& a, const IntegerVector3& b);
inline bool is_zero(const IntegerVector3& v) noexcept {
    return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
}

// A parameter m 2^e, which may be the midpoint of two doubles.
struct Parameter {
    std::int64_t m = 0;
    int e = 0;
};

class ExactPoints {
  public:
    // The points of two bodies. Everything that the arguments refer to must outlive the points.
    ExactPoints(const exact::BodyRef& a, const exact::BodyRef& b);
    // Those of a body, and those at parameters of a segment that are multiples of 2^e, or 0.
    ExactPoints(const exact::BodyRef& a, const Segment& segment, const Parameter& finest);

    IntegerVector3 vertex(std::size_t body, std::uint32_t index) const;
    // from + s (to - from)
    IntegerVector3 on_segment(const Segment& segment, const Parameter& s) const;

  private:
    void add(exact::Integer& sum, exact::Int128 m, int e) const;

    std::array<exact::BodyRef, 2> bodies_{};
    int low_ = 0;  // all coordinates are multiples of 2^low_
};

}  // namespace ecods
