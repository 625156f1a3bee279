// Computes the intervals of boxes or triangles of nodes and leaves along an axis, and compares the intervals of two
// nodes. The error bounds are derived in body_axis.hpp.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/pose.hpp"
#include "simd/inline.hpp"
#include "simd/vec.hpp"

namespace ecods {

struct BodyAxis {
    std::array<double, 3> p{};
    double q = 0;
    double error = 0;
    double corner_reach = 0;  // error bound of a leaf's corner
    bool is_bounded = false;  // if false, the error bounds do not hold

    double at(const Vec3& y) const noexcept { return p[0] * y[0] + p[1] * y[1] + p[2] * y[2] + q; }
};

// Reaches holds the interval of each lane along an axis. Lanes beyond the last used lane repeat its interval.
template <class Number>
struct Reaches {
    alignas(32) std::array<Number, tree_width> low;
    alignas(32) std::array<Number, tree_width> high;

    // Sets each lane to the union of all intervals.
    ECODS_ALWAYS_INLINE void join_lanes() noexcept {
        Number least = low[0], most = high[0];
        for (std::size_t lane = 1; lane < tree_width; ++lane) {
            least = low[lane] < least ? low[lane] : least;
            most = high[lane] > most ? high[lane] : most;
        }
        low.fill(least);
        high.fill(most);
    }
};

// InDoubles computes intervals of boxes and triangles in doubles, without the axis's error.
struct InDoubles {
    using Half = Vec<double, 4>;

    ECODS_ALWAYS_INLINE static Half load(const FloatLanes& lanes, std::size_t part) noexcept {
        return convert<Half>(ecods::load<Vec<float, 4>>(&lanes[4 * part]));
    }

    ECODS_ALWAYS_INLINE static void find_ends(const BodyAxis& axis, const BvhNode& node, std::size_t part, Half& low,
                                              Half& high) noexcept {
        const auto& p = axis.p;
        const Half middle = (p[0] * load(node.center[0], part) + p[1] * load(node.center[1], part)) +
                            (p[2] * load(node.center[2], part) + axis.q);
        const Half reach = (std::abs(p[0]) * load(node.half[0], part) + std::abs(p[1]) * load(node.half[1], part)) +
                           std::abs(p[2]) * load(node.half[2], part);
        low = middle - reach;
        high = middle + reach;
    }
    ECODS_ALWAYS_INLINE static Half corner(const BodyAxis& axis, const TreeLeaf& leaf, std::size_t c,
                                           std::size_t part) noexcept {
        const auto& p = axis.p;
        const auto& y = leaf.corner[c];
        return (p[0] * load(y[0], part) + p[1] * load(y[1], part)) + (p[2] * load(y[2], part) + axis.q);
    }
    ECODS_ALWAYS_INLINE static void find_ends(const BodyAxis& axis, const TreeLeaf& leaf, std::size_t part, Half& low,
                                              Half& high) noexcept {
        const Half x = corner(axis, leaf, 0, part), y = corner(axis, leaf, 1, part), z = corner(axis, leaf, 2, part);
        low = min(x, min(y, z)) - axis.corner_reach;
        high = max(x, max(y, z)) + axis.corner_reach;
    }

    // Sets `reaches` to the intervals of the lanes of x, enlarged by `margin` on both sides.
    template <class X>
    ECODS_ALWAYS_INLINE static void find_reaches(const BodyAxis& axis, double margin, const X& x,
                                                 Reaches<double>& reaches) noexcept {
        for (std::size_t part = 0; part < 2; ++part) {
            Half low, high;
            find_ends(axis, x, part, low, high);
            store(&reaches.low[4 * part], low - margin);
            store(&reaches.high[4 * part], high + margin);
        }
    }
};

// Returns the pairs whose intervals are disjoint: bit 8 i + j stands for lane i of x and lane j of y. Tests all lanes
// i, and the lanes j that are set in `columns`.
template <std::size_t width, class Number>
ECODS_ALWAYS_INLINE std::uint64_t apart_lanes(const Reaches<Number>& x, const Reaches<Number>& y,
                                              std::uint32_t columns) noexcept {
    using Numbers = Vec<Number, width>;
    constexpr std::size_t part_count = tree_width / width;
    MaskOf<Numbers> apart[part_count]{};
    for (; columns != 0; columns &= columns - 1) {
        const auto j = static_cast<std::size_t>(std::countr_zero(columns));
        for (std::size_t part = 0; part < part_count; ++part) {
            apart[part] |= ((load<Numbers>(&x.high[part * width]) < y.low[j]) |
                            (load<Numbers>(&x.low[part * width]) > y.high[j])) &
                           (1 << j);
        }
    }
    std::uint64_t pairs = 0;
    for (std::size_t part = 0; part < part_count; ++part) pairs |= low_bytes(apart[part]) << (8 * part * width);
    return pairs;
}

}  // namespace ecods
