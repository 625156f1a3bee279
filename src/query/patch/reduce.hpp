// Chooses the corners of a patch that max_corners keeps.
#pragma once

#include <cstddef>
#include <vector>

#include "query/patch/seen_along.hpp"

namespace ecods::patches {

// Returns the numbers of `count` of the points, ascending: the first point, and of all choices that contain it the one
// whose polygon has the greatest area, seen along the normal; of ties the lexicographically first. Two points are the
// first and the one furthest from it across the normal. The points are the corners of a convex polygon, in order;
// `count` is at least 1 and less than their number. Exact.
//
// The polygon from the first point c over points i < j < ... has the sum of the areas of triangles (c, i, j), (c, j,
// ...). So the best choice of k points that ends at j is the best one of k - 1 points that ends at some i < j, and (c,
// i, j): of m points, m^2 areas, and `count` m^2 sums and comparisons, most
// of which bounds in doubles decide.
std::vector<std::size_t> choose_corners(const std::vector<LongPoint>& points, const ScaledLongVector& normal,
                                        std::size_t count);

}  // namespace ecods::patches
