// ContactInterval bounds the time of first contact of two moving triangles, and names the features that touch then.
#pragma once

#include <limits>
#include <optional>
#include <tuple>

#include "ecods/cast.hpp"
#include "geometry/feature_key.hpp"

namespace ecods {

struct ContactInterval {
    // lower bound of the time of first contact; infinity if there is no contact; 0 if no bound is known
    double lower = 0;
    // upper bound of the time of first contact; infinity if a contact is not certain
    double upper = std::numeric_limits<double>::infinity();

    // `is_certain` is true if the triangles certainly first touch at a single point that is in the relative interiors
    // of features a and b of `contact`. All pairs of triangles with these two features then have the same first
    // contact.
    bool is_certain = false;
    FirstContact contact;  // names features by these triangles; contact.time is not set
    FeatureKey a, b;
};

// Returns the first of a sieve's open contacts: the contact with the least rounded time; among equal times, the one
// with the least rank. round(open) must return the contact of a pair, or nullopt if the pair has none.
template <class Sieve, class Round>
std::optional<FirstContact> first_contact(Sieve& sieve, Round&& round) {
    return sieve.least([&](const auto& open, const auto&) { return round(open); },
                       [](const FirstContact& c) { return c.time; }, [](const FirstContact& c) { return rank(c); });
}

}  // namespace ecods
