// Boxes as integers, so that which boxes overlap cannot depend on the floating-point environment.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "ecods/aabb.hpp"

namespace ecods {

// An integer that orders as the double does, infinities included; -0.0 and 0.0 have one key. Only bits are looked at:
// with denormals-are-zero set, a comparison of doubles would take subnormals for equal.
constexpr std::int64_t key_of(double x) noexcept {
    const auto bits = std::bit_cast<std::int64_t>(x);
    const std::int64_t sign = bits >> 63;  // all ones below zero
    return ((bits & std::numeric_limits<std::int64_t>::max()) ^ sign) - sign;
}

// The double that has this key.
constexpr double double_of(std::int64_t key) noexcept {
    const std::int64_t sign = key >> 63;
    return std::bit_cast<double>(((key ^ sign) - sign) | (sign & std::numeric_limits<std::int64_t>::min()));
}

struct KeyBox {
    std::array<std::int64_t, 3> min{};
    std::array<std::int64_t, 3> max{};

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
