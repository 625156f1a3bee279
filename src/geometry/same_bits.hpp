// Whether two poses are written the same.
#pragma once

#include <cstring>

#include "ecods/pose.hpp"

namespace ecods {

// A comparison of bits, not of values: where the processor takes subnormals for zero, values that differ compare equal.
inline bool same_bits(const Pose& a, const Pose& b) noexcept {
    // NOLINTBEGIN(bugprone-suspicious-memory-comparison): which it says of comparisons of bits.
    return std::memcmp(a.R.data(), b.R.data(), 9 * sizeof(double)) == 0 &&
           std::memcmp(a.t.data(), b.t.data(), 3 * sizeof(double)) == 0;
    // NOLINTEND(bugprone-suspicious-memory-comparison)
}

}  // namespace ecods
