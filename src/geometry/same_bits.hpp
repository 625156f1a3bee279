// Whether two poses are written the same.
#pragma once

#include <cstdint>

#include "ecods/pose.hpp"
#include "simd/vec.hpp"

namespace ecods {

// A comparison of bits, not of values: where the processor takes subnormals for zero, values that differ compare equal.
// Where bodies move their translations differ, as a rule: those are compared first.
inline bool same_bits(const Pose& a, const Pose& b) noexcept {
    using Two = Vec<std::uint64_t, 2>;
    const auto* const Ra = reinterpret_cast<const std::uint64_t*>(a.R.data());  // read as vectors, which may alias
    const auto* const Rb = reinterpret_cast<const std::uint64_t*>(b.R.data());
    const auto* const ta = reinterpret_cast<const std::uint64_t*>(a.t.data());
    const auto* const tb = reinterpret_cast<const std::uint64_t*>(b.t.data());
    const auto differ = [](const std::uint64_t* x, const std::uint64_t* y) -> Two {
        return load_anywhere<Two>(x) ^ load_anywhere<Two>(y);
    };
    const Two t = differ(ta, tb) | differ(ta + 1, tb + 1);
    if (any_bits(t) != 0) return false;
    const Two low = differ(Ra, Rb) | differ(Ra + 2, Rb + 2), high = differ(Ra + 4, Rb + 4) | differ(Ra + 6, Rb + 6);
    return any_bits(low | high | differ(Ra + 7, Rb + 7)) == 0;
}

}  // namespace ecods
