// TriangleContacts computes the first contact of pairs of triangles of two meshes, the first of which is translated.
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
    // Binds mesh a, which is translated by `motion`, and mesh b. The motion must be finite and not zero. All objects
    // that the arguments refer to must outlive this object. Cost: constant.
    void bind(const exact::BodyRef& a, const Vec3& motion, const exact::BodyRef& b);

    // Returns an interval, with bounds that doubles prove, that contains the time of first contact of triangle `i` of
    // the first mesh and triangle `j` of the second.
    ContactInterval enclose(std::uint32_t i, std::uint32_t j);

    // Returns the first contact of triangles i and j from time 0 to 1; nullopt if there is none. If several features
    // touch first, the rule of FirstContact chooses. `known` must be the result of enclose(i, j).
    std::optional<FirstContact> contact(std::uint32_t i, std::uint32_t j, const ContactInterval& known);

    // Returns true if triangles i and j share a point at some time from 0 to `latest`.
    bool meet_by(std::uint32_t i, std::uint32_t j, double latest);

    // An Entry describes how triangle i of the first mesh goes into triangle j of the second one, from time 0 to `end`.
    struct Entry {
        // `time` is the time at which the first triangle goes properly into the second one (ContactTimes), rounded
        // once; empty if there is no such time before `end`, in real time.
        std::optional<double> time;
        // Bit e is set if edge e of triangle i is in the plane of triangle j and slides along it; bit 3 + e is set if
        // edge e of triangle j is in the plane of triangle i and slides along it.
        std::uint8_t sliding_edges = 0;
    };
    // Returns the Entry of triangles i and j. Searches for sliding edges only if `with_edges` is true and the pair does
    // not go in properly. If `with_edges` is true, both triangles must have an area.
    Entry entry(std::uint32_t i, std::uint32_t j, double end, bool with_edges);

  private:
    template <class Use>
    auto with_integers(std::uint32_t i, std::uint32_t j, Use&& use);
    exact::IntegerPair integers(std::uint32_t i, std::uint32_t j);

    exact::IntegerFrame points_;
    std::array<const Triangle*, 2> triangles_{};
    Vec3 motion_ = Vec3::Zero();
    exact::ScaledVector scaled_{};
    // Holds the motion in the unit of the points; set only if is_exact_.
    exact::IntegerVector integer_motion_{};
    bool is_exact_ = false;
};

}  // namespace ecods
