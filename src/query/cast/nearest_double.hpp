// nearest_double rounds a real number about which only comparisons are known.
#pragma once

#include <cstdint>
#include <limits>

#include "base/double_key.hpp"
#include "query/cast/exact_turn.hpp"

namespace ecods {

// Returns the double nearest to a number from 0 to 8 that is not half-way between two doubles. `is_above(m)` says if
// the number is above m. The guess affects only the work: galloping search around it.
template <class IsAbove>
double nearest_double(double guess, IsAbove&& is_above) {
    constexpr std::int64_t last = key_of(8.0);
    // True if the nearest double is after double number k.
    const auto is_after = [&](std::int64_t k) { return is_above(middle_of(double_of(k), double_of(k + 1))); };
    std::int64_t key = guess >= 0 && guess <= 8 ? key_of(guess) : 0;
    std::int64_t below = key, above = key, step = 1;  // the answer is in (below, above]
    if (is_after(key)) {
        do {
            below = above;
            above = step < last - above ? above + step : last;
            step *= 2;
        } while (above < last && is_after(above));
    } else {
        do {
            above = below;
            below = step <= below ? below - step : -1;
            step *= 2;
        } while (below >= 0 && !is_after(below));
    }
    while (above - below > 1) {
        const std::int64_t middle = below + (above - below) / 2;
        (is_after(middle) ? below : above) = middle;
    }
    return double_of(above);
}

}  // namespace ecods
