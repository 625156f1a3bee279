// A LongVector has integer coordinates of any length; a ScaledLongVector, integers times powers of two. Both are used
// for an exact result that is needed once, not in a search.
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

inline bool is_zero(const ScaledLongVector& v) noexcept {
    return v[0].sign() == 0 && v[1].sign() == 0 && v[2].sign() == 0;
}

inline ScaledLongVector times(const ScaledLongVector& v, const ScaledInteger& x) {
    return {v[0] * x, v[1] * x, v[2] * x};
}
inline ScaledLongVector plus(const ScaledLongVector& v, const ScaledLongVector& w) {
    return {v[0] + w[0], v[1] + w[1], v[2] + w[2]};
}

inline Integer square(const Integer& x) {
    return x * x;
}

}  // namespace ecods::exact
