// Guesses the closest features of two convex solids in doubles (Gilbert, Johnson and Keerthi, 1988).
#pragma once

#include <array>
#include <cstdint>

#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {

// A simplex of the Minkowski difference: pairs of vertices, one of each solid, and the points second minus first.
struct Simplex {
    int count = 0;
    std::array<std::array<std::uint32_t, 2>, 4> pairs{};
    std::array<Point, 4> points{};
};

// The pair of vertices nearest along the rounded direction between the centers: the start of a search without a
// witness.
Simplex between_centers(const PosedHulls& hulls) noexcept;

// Finds the smallest simplex that contains the point nearest to the origin, as far as doubles know; it has four pairs
// if the origin is inside. `start` has at least one pair; a nearer start only saves time.
Simplex run_gjk(const PosedHulls& hulls, const Simplex& start) noexcept;

// Runs GJK for two triangles of vertices in place of the solids.
Simplex run_gjk_of_triangles(const PosedHulls& hulls,
                             const std::array<std::array<std::uint32_t, 3>, 2>& triangles) noexcept;

}  // namespace ecods::convex
