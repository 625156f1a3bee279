// A guess of the closest features of two convex solids, in doubles (Gilbert, Johnson and Keerthi, 1988).
#pragma once

#include <array>
#include <cstdint>

#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {

// Pairs of vertices, one of each solid: points of the set of differences, second less first.
struct Simplex {
    int count = 0;
    std::array<std::array<std::uint32_t, 2>, 4> pairs{};
    std::array<Point, 4> points{};
};

// The pair that is nearest along the way from one center to the other, about: where a search begins that knows no
// better.
Simplex between_centers(const PosedHulls& hulls) noexcept;

// The least pairs of which the nearest point to the origin is a combination, if doubles are right; four if the origin
// is inside. From at least one pair; how near it is is only a matter of time.
Simplex run_gjk(const PosedHulls& hulls, const Simplex& start) noexcept;

// The same for two triangles of vertices in place of the solids.
Simplex run_gjk_of_triangles(const PosedHulls& hulls,
                             const std::array<std::array<std::uint32_t, 3>, 2>& triangles) noexcept;

}  // namespace ecods::convex
