// ExactPoints computes posed vertices, and points of a segment, as integers of any length in units of one power of two.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/primitives.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/long_vector.hpp"
#include "exact/point/pose_terms.hpp"
#include "exact/point/posed_points.hpp"
#include "exact/point/vectors.hpp"

namespace ecods {

inline bool is_zero(const exact::LongVector& v) noexcept {
    return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
}

// Parameter is a parameter m 2^e of a segment. It may be the midpoint of two doubles, which a double cannot hold.
struct Parameter {
    std::int64_t m = 0;
    int e = 0;
};

class ExactPoints {
  public:
    // Chooses the unit for the vertices of two bodies. Everything that the arguments refer to must outlive this object.
    ExactPoints(const exact::BodyRef& a, const exact::BodyRef& b) noexcept;
    // Chooses the unit for the vertices of a body, and for the points of the segment whose parameters are multiples of
    // 2^finest.e.
    ExactPoints(const exact::BodyRef& a, const Segment& segment, const Parameter& finest) noexcept;

    exact::LongVector vertex(std::size_t body, std::uint32_t index) const {
        return terms_[body].point_in<exact::Integer>(unit_, meshes_[body]->vertices()[index]);
    }
    // Returns the point from + s (to - from) of the segment.
    exact::LongVector on_segment(const Segment& segment, const Parameter& s) const;

  private:
    exact::BitRange bind(std::size_t body, const exact::BodyRef& of) noexcept;

    std::array<const Mesh*, 2> meshes_{};
    std::array<exact::PoseTerms, 2> terms_;
    int unit_ = 0;  // coordinates are counted in units of 2^unit_
};

}  // namespace ecods
