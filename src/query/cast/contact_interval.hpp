// What is known of the first time at which two triangles on their way share a point, and of the features they do on.
#pragma once

#include <limits>
#include <tuple>

#include "base/double_key.hpp"
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

inline auto rank_in_time(const FirstContact& c) noexcept {
    return std::tuple_cat(std::tuple(key_of(c.time)), rank(c));
}

}  // namespace ecods
