// Defines vertices and faces of the Minkowski difference of two convex solids, and an order of the faces.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "query/convex/hull_features.hpp"

namespace ecods::depths {

// A DifferenceVertex is a vertex p of the first solid minus a vertex q of the second, both as indices in the hulls. The
// Minkowski difference of two convex solids is the convex hull of all these points.
struct DifferenceVertex {
    std::uint32_t p = 0;
    std::uint32_t q = 0;

    std::uint32_t of(std::size_t side) const noexcept { return side == 0 ? p : q; }
    friend bool operator==(const DifferenceVertex&, const DifferenceVertex&) = default;
};

// A DifferenceFace is a face of the Minkowski difference. It is given by the feature of the first solid that is extreme
// along the face's outer normal, and the feature of the second solid that is extreme in the opposite direction. One of
// the two is a face, or both are edges that are not parallel. A polygon's face has two normals.
using DifferenceFace = std::array<convex::HullFeature, 2>;

// Returns the order of two faces at exactly the same distance, by which one is chosen: faces of the first solid come
// first, then faces of the second, then pairs of edges; among each, the lesser index. If the same polygon is a face of
// both sides of the difference, the other solid's feature decides: a vertex before an edge before a face, then the
// lesser index. If the Minkowski difference does not lie in a plane, no two of its faces are equal in this order.
inline std::strong_ordering order_of(const DifferenceFace& x, const DifferenceFace& y) noexcept {
    const auto rank = [](const DifferenceFace& f) -> std::array<std::uint32_t, 4> {
        const auto kind = [&](std::size_t side) { return static_cast<std::uint32_t>(f[side].kind); };
        if (f[0].kind == Feature::Kind::face) return {0, f[0].index, kind(1), f[1].index};
        if (f[1].kind == Feature::Kind::face) return {1, f[1].index, kind(0), f[0].index};
        return {2, f[0].index, f[1].index, 0};
    };
    return rank(x) <=> rank(y);
}

// Reduces the lists `levels` to their vertices that are furthest along a normal. Returns the furthest vertex of the
// difference if it is further than `corner`; otherwise nullopt, and the lists then hold the vertices that are as far as
// the corner. The lists must contain all vertices that are extreme along the normal, or for the second solid in the
// opposite direction. further(side, from, to) must return the sign of (height of vertex `to` - height of vertex
// `from`).
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
