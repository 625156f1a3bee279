// Bounds the first time at which two moving triangles share a point, and names the features that meet then.
#pragma once

#include <limits>
#include <optional>
#include <tuple>

#include "ecods/cast.hpp"
#include "geometry/feature_key.hpp"

namespace ecods {

struct ContactInterval {
    // Lower bound of the time of first contact; infinity if there is no contact; 0 if nothing is known.
    double lower = 0;
    // Upper bound of the time of first contact; infinity if a contact is not certain.
    double upper = std::numeric_limits<double>::infinity();

    // True if the first contact is certainly at one point, inside these two features and no others. Pairs of triangles
    // with the same two features have the same first contact.
    bool is_certain = false;
    FirstContact contact;  // named by these triangles; `time` is not set
    FeatureKey a, b;
};

// The first of a sieve's open contacts by rounded time, then by rank; round(open) gives the contact of a pair, if it
// has one.
template <class Sieve, class Round>
std::optional<FirstContact> first_contact(Sieve& sieve, Round&& round) {
    return sieve.least([&](const auto& open, const auto&) { return round(open); },
                       [](const FirstContact& c) { return c.time; }, [](const FirstContact& c) { return rank(c); });
}

}  // namespace ecods
