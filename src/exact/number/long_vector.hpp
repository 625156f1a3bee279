// A LongVector has integer coordinates of any length; a ScaledLongVector, integers times powers of two. They serve
// where an exact result is needed once, not in a search.
#pragma once

#include <array>
#include <cstddef>

#include "exact/number/dyadic.hpp"
#include "exact/number/integer.hpp"
#include "exact/number/scaled_integer.hpp"

namespace ecods::exact {

using LongVector = std::array<Integer, 3>;
using ScaledLongVector = std::array<ScaledInteger, 3>;

// Returns x / 2^unit, which must be an integer.
inline Integer in_units(const Dyadic& x, int unit) {
    return ScaledInteger(x).in_units(unit);
}

inline Integer square(const Integer& x) {
    return x * x;
}

}  // namespace ecods::exact
