// What is known of the first time at which two triangles on their way share a point, and of the features they do on.
#pragma once

#include <limits>
#include <optional>
#include <tuple>

#include "ecods/cast.hpp"
#include "geometry/feature_key.hpp"

namespace ecods {

struct ContactInterval {
    // From time 0 on there is no contact before; infinity if there is none. 0 says nothing.
    double lower = 0;
    // The first contact is not later; infinity if it is not known whether there is one.
    double upper = std::numeric_limits<double>::infinity();

    // Where this is set, the first contact is at one point, inside these two features and no others. Pairs of triangles
    // that have the same features have the same first contact.
    bool is_certain = false;
    FirstContact contact;  // by these triangles; `time` is not set
    FeatureKey a, b;
};

// The first of the open contacts of a sieve by their rounded times and ranks; round(open) gives that of a pair, if
// there is one.
template <class Sieve, class Round>
std::optional<FirstContact> first_contact(Sieve& sieve, Round&& round) {
    return sieve.least([&](const auto& open, const auto&) { return round(open); },
                       [](const FirstContact& c) { return c.time; }, [](const FirstContact& c) { return rank(c); });
}

}  // namespace ecods
