// Boxes as integers, so that which boxes overlap cannot depend on the floating-point environment.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "ecods/aabb.hpp"

namespace ecods {

// An integer that orders as the double does, infinities included; -0.0 and 0.0 have one key. Only bits are looked at:
// with denormals-are-zero set, a comparison of doubles would take subnormals for equal.
constexpr std::uint64_t key_of(double x) noexcept {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    if (bits == sign) return sign;
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

struct KeyBox {
    std::array<std::uint64_t, 3> min{};
    std::array<std::uint64_t, 3> max{};

    friend bool operator==(const KeyBox&, const KeyBox&) = default;
};

inline KeyBox key_box(const Aabb& box) noexcept {
    KeyBox keys;
    for (int axis = 0; axis < 3; ++axis) {
        keys.min[axis] = key_of(box.min[axis]);
        keys.max[axis] = key_of(box.max[axis]);
    }
    return keys;
}

// Whether the closed boxes share a point.
inline bool overlap(const KeyBox& a, const KeyBox& b) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.min[axis] > b.max[axis] || b.min[axis] > a.max[axis]) return false;
    }
    return true;
}

}  // namespace ecods
