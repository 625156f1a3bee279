// Answers queries about the first contact of pairs of triangles of two posed meshes, of which the first is translated.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ecods/cast.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/point/integer_frame.hpp"
#include "query/cast/contact_interval.hpp"

namespace ecods {

class TriangleContacts {
  public:
    // Cost: constant. Everything that the arguments refer to must outlive this. The motion must be finite and not zero.
    void bind(const exact::BodyRef& a, const Vec3& motion, const exact::BodyRef& b);

    // An interval that contains the time of first contact of triangle `i` of the first mesh and `j` of the second, from
    // doubles with proven bounds.
    ContactInterval enclose(std::uint32_t i, std::uint32_t j);

    // The first contact from time 0 to 1, with the first features by the rule of FirstContact. `known` must be the
    // result of enclose() for the pair.
    std::optional<FirstContact> contact(std::uint32_t i, std::uint32_t j, const ContactInterval& known);

    // True if the triangles share a point from time 0 to `latest`.
    bool meet_by(std::uint32_t i, std::uint32_t j, double latest);

  private:
    template <class Use>
    auto with_integers(std::uint32_t i, std::uint32_t j, Use&& use);
    exact::IntegerPair integers(std::uint32_t i, std::uint32_t j);

    exact::IntegerFrame points_;
    std::array<const Triangle*, 2> triangles_{};
    Vec3 motion_ = Vec3::Zero();
    exact::ScaledVector scaled_{};
    // The motion in the points' unit; set if is_exact_.
    exact::IntegerVector integer_motion_{};
    bool is_exact_ = false;
};

}  // namespace ecods
