// A guess at what decides when two triangles first share a point, of which the first is translated.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"
#include "exact/measure/round/scaled_vector.hpp"

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

// The guess is made in plain doubles; `m` is the motion of the first triangle.
ContactGuess guess_contact(const IntegerPair& pair, const ScaledVector& m) noexcept;

}  // namespace ecods::exact
