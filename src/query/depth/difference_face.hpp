// Vertices and faces of the set of differences of two convex solids, and the order of these faces.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "query/convex/hull_features.hpp"

namespace ecods::depths {

// A vertex p of the first solid less a vertex q of the second, by their indices in the hulls. The set of differences of
// two convex solids is the hull of these.
struct DifferenceVertex {
    std::uint32_t p = 0;
    std::uint32_t q = 0;

    std::uint32_t of(std::size_t side) const noexcept { return side == 0 ? p : q; }
    friend bool operator==(const DifferenceVertex&, const DifferenceVertex&) = default;
};

// A face of the set of differences: what of the first solid is furthest along its outer normal, and what of the second
// is furthest against it. One of them is a face, or both are edges that are not parallel.
using DifferenceFace = std::array<convex::HullFeature, 2>;

// The order in which one of several faces is chosen that are at exactly one distance: faces of the first solid, then of
// the second, then pairs of edges. No two faces of the set of differences are equal in it.
inline std::strong_ordering order_of(const DifferenceFace& x, const DifferenceFace& y) noexcept {
    const auto rank = [](const DifferenceFace& f) -> std::array<std::uint32_t, 3> {
        if (f[0].kind == Feature::Kind::face) return {0, f[0].index, 0};
        if (f[1].kind == Feature::Kind::face) return {1, f[1].index, 0};
        return {2, f[0].index, f[1].index};
    };
    return rank(x) <=> rank(y);
}

// Of lists of vertices of both solids, among which are all that are furthest along a normal, and against it: returns
// what is furthest if it is further than `corner`, and otherwise keeps those that are as far. further(side, from, to)
// is the sign of how much further `to` is than `from`.
template <class Further>
std::optional<DifferenceVertex> keep_level(std::array<std::vector<std::uint32_t>, 2>& levels,
                                           const DifferenceVertex& corner, Further&& further) {
    std::array<std::uint32_t, 2> best{corner.p, corner.q};
    for (std::size_t side = 0; side < 2; ++side) {
        std::size_t kept = 0;
        for (const std::uint32_t v : levels[side]) {
            const int sign = v == best[side] ? 0 : further(side, best[side], v);
            if (sign > 0) {
                best[side] = v;
                kept = 0;
            }
            if (sign >= 0) levels[side][kept++] = v;
        }
        levels[side].resize(kept);
    }
    const DifferenceVertex furthest{best[0], best[1]};
    const bool is_level = further(0, corner.p, furthest.p) == 0 && further(1, corner.q, furthest.q) == 0;
    return is_level ? std::nullopt : std::optional(furthest);
}

}  // namespace ecods::depths
