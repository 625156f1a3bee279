// The corpus of posed triangle pairs as a file of doubles: for each pair R (rows), t and three corners of either body.
#pragma once

#include <array>
#include <cstddef>

namespace ecods::environment {

inline constexpr std::size_t doubles_per_body = 9 + 3 + 9;
using PairRecord = std::array<double, 2 * doubles_per_body>;

}  // namespace ecods::environment
