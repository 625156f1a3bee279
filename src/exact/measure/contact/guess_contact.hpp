// A guess at what decides when two triangles first share a point, of which the first is translated.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/point/point.hpp"

namespace ecods::exact {

struct ContactGuess {
    enum class What : std::uint8_t {
        meeting,  // they first share a point on these features
        leaving,  // they share none any more from a time before 0 on, when they did on these
        passing,  // seen along the motion, the edge of `features` that begins at corner a or b of the triangle
                  // `vertex_side` has the other triangle beyond it, whose nearest corner the other one is
    };

    What what = What::meeting;
    FeaturePair features;
};

// For six points and the direction of the first three, all below 2^53, in plain doubles.
ContactGuess guess_contact(const Points<6>& points, const Point& m) noexcept;

}  // namespace ecods::exact
