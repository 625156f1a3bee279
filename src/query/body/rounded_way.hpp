// RoundedWay computes the times at which triangles of a translated boundary are within a distance p of triangles of
// another boundary.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "exact/measure/contact/rounded_contact.hpp"
#include "geometry/feature_key.hpp"
#include "query/body/earliest.hpp"

namespace ecods {

// NearTimes holds the interval of times, from 0 on, at which two triangles are within p, and the features with closest
// points at both ends of the interval.
struct NearTimes {
    exact::RoundedContact::Interval interval;
    FeatureNames first, last;
};

class RoundedWay {
  public:
    // Takes boundary a, which is translated by `motion`, and boundary b at rest. `motion` is exact, and not zero; p
    // must be positive. Everything that the arguments refer to must outlive this object.
    RoundedWay(const Posed<MeshShape>& a, const exact::ScaledLongVector& motion, const Posed<MeshShape>& b,
               const exact::ExactSum& p)
        : a_(a), motion_(motion), b_(b), p_(p) {}

    // Returns the interval of times at which the pair is within p; nullopt if there are none. Cost: some exact
    // operations for each pair of features of the two triangles.
    std::optional<NearTimes> times(const TrianglePair& pair) const;

    // Adds the times of the pairs that come within p and were not added before.
    void add(const PairList& pairs);
    const std::vector<NearTimes>& found() const noexcept { return found_; }

  private:
    exact::ScaledLongVector corner(const Posed<MeshShape>& body, std::uint32_t triangle, std::size_t i) const;

    const Posed<MeshShape>& a_;
    const exact::ScaledLongVector& motion_;
    const Posed<MeshShape>& b_;
    const exact::ExactSum& p_;
    std::unordered_set<std::uint64_t> seen_;
    std::vector<NearTimes> found_;
};

}  // namespace ecods
