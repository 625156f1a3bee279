// A KeyBox is a box whose ends are keys of doubles (base/double_key.hpp). Comparisons of KeyBoxes do not depend on the
// floating-point environment.
#pragma once

#include <array>
#include <cstdint>

#include "base/double_key.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

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

// Returns true if the closed boxes share a point.
inline bool overlap(const KeyBox& a, const KeyBox& b) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.min[axis] > b.max[axis] || b.min[axis] > a.max[axis]) return false;
    }
    return true;
}

}  // namespace ecods
