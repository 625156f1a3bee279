// Represents the ends of boxes on an axis, in a total order.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "geometry/key_box.hpp"

namespace ecods {

// Holds one end of a box on an axis; `key` is the coordinate as an integer with the same order. Ends are totally
// ordered: by coordinate; at equal coordinates a minimum before a maximum, since boxes are closed; then by proxy. So
// the order of a list is a function of the boxes alone, and binary search finds an end.
struct Endpoint {
    static constexpr std::uint32_t max_bit = std::uint32_t{1} << 31;

    std::int64_t key = 0;
    std::uint32_t tag = 0;  // the proxy, with max_bit set for a maximum

    bool is_max() const noexcept { return (tag & max_bit) != 0; }
    ProxyIndex proxy() const noexcept { return tag & ~max_bit; }

    friend constexpr bool operator<(const Endpoint& a, const Endpoint& b) noexcept {
        return a.key < b.key || (a.key == b.key && a.tag < b.tag);
    }
};

// Lists the ends of all boxes on one axis, ascending.
using EndpointList = std::vector<Endpoint>;

inline Endpoint min_end(const KeyBox& box, ProxyIndex proxy, int axis) noexcept {
    return {box.min[axis], proxy};
}
inline Endpoint max_end(const KeyBox& box, ProxyIndex proxy, int axis) noexcept {
    return {box.max[axis], proxy | Endpoint::max_bit};
}

}  // namespace ecods
