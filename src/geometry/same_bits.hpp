// Poses and points are compared by their bits, not by their values: if the processor takes subnormal numbers for zero,
// different values may compare equal.
#pragma once

#include <cstdint>

#include "base/hash.hpp"
#include "ecods/pose.hpp"
#include "simd/vec.hpp"

namespace ecods {

// Returns true if a and b are the same point; -0 and 0 are the same coordinate.
inline bool same_point(const Vec3& a, const Vec3& b) noexcept {
    return coordinate_bits(a[0]) == coordinate_bits(b[0]) && coordinate_bits(a[1]) == coordinate_bits(b[1]) &&
           coordinate_bits(a[2]) == coordinate_bits(b[2]);
}

// Returns true if a and b are the same matrix; -0 and 0 are the same entry.
inline bool same_matrix(const Mat3& a, const Mat3& b) noexcept {
    return same_point(a.col(0), b.col(0)) && same_point(a.col(1), b.col(1)) && same_point(a.col(2), b.col(2));
}

// Returns true if all entries of a and b have the same bits.
inline bool same_bits(const Mat3& a, const Mat3& b) noexcept {
    using Two = Vec<std::uint64_t, 2>;
    const auto* const x = reinterpret_cast<const std::uint64_t*>(a.data());  // vectors may alias doubles
    const auto* const y = reinterpret_cast<const std::uint64_t*>(b.data());
    const auto differ = [&](int i) -> Two { return load_anywhere<Two>(x + i) ^ load_anywhere<Two>(y + i); };
    const Two low = differ(0) | differ(2), high = differ(4) | differ(6);
    return any_bits(low | high | differ(7)) == 0;
}

// Returns true if all entries of a and b have the same bits. Compares translations first, because the translation of a
// moving body usually changes.
inline bool same_bits(const Pose& a, const Pose& b) noexcept {
    using Two = Vec<std::uint64_t, 2>;
    const auto* const x = reinterpret_cast<const std::uint64_t*>(a.t.data());
    const auto* const y = reinterpret_cast<const std::uint64_t*>(b.t.data());
    const auto differ = [&](int i) -> Two { return load_anywhere<Two>(x + i) ^ load_anywhere<Two>(y + i); };
    const Two t = differ(0) | differ(1);
    return any_bits(t) == 0 && same_bits(a.R, b.R);
}

}  // namespace ecods
