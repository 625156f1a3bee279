// Which bodies are meant to meet at all.
#pragma once

#include <cstdint>

#include "ecods/export.hpp"

namespace ecods {

// A body is in groups, and its mask names the groups that it meets. Two bodies may meet if each is in a group that the
// other's mask names. By default a body is in the first group and meets all: everything may meet. A body whose mask is
// zero meets nothing.
struct CollisionFilter {
    std::uint64_t groups = 1;
    std::uint64_t mask = ~std::uint64_t{0};

    friend constexpr bool operator==(const CollisionFilter&, const CollisionFilter&) = default;
};

constexpr bool may_meet(const CollisionFilter& a, const CollisionFilter& b) noexcept {
    return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0;
}

}  // namespace ecods
