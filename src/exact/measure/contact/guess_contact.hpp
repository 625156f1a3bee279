// guess_contact() guesses which features first share a point if the first one of two triangles is translated.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"
#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::exact {

struct ContactGuess {
    enum class What : std::uint8_t {
        meeting,  // the triangles first share a point on `features`
        leaving,  // all contact is before time 0; `features` are those that touch at its end
        passing,  // seen along the motion, an edge of the triangle vertex_side separates them: `features` holds the
                  // corner where that edge begins, and the nearest corner of the other triangle
    };

    What what = What::meeting;
    FeaturePair features;
};

// Returns a guess computed in doubles, without error bounds. `m` is the motion of the first triangle.
ContactGuess guess_contact(const IntegerPair& pair, const ScaledVector& m) noexcept;

}  // namespace ecods::exact
