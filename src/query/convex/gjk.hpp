// Guesses the closest features of two convex solids in doubles, by the algorithm of Gilbert, Johnson and Keerthi
// (1988).
#pragma once

#include <array>
#include <cstdint>

#include "query/convex/gjk_rounds.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {

// Returns the support vertices of both solids along the rounded direction between their centers, as a simplex of one
// pair. A search without a witness starts from it.
Simplex between_centers(const PosedHulls& hulls) noexcept;

// Returns the smallest simplex that contains the point nearest to the origin, as far as doubles show. It has four pairs
// if the origin is inside. `start` must have at least one pair; a nearer start only saves time.
Simplex run_gjk(const PosedHulls& hulls, const Simplex& start) noexcept;

// Runs GJK for two triangles of vertices instead of the solids.
Simplex run_gjk_of_triangles(const PosedHulls& hulls,
                             const std::array<std::array<std::uint32_t, 3>, 2>& triangles) noexcept;

}  // namespace ecods::convex
