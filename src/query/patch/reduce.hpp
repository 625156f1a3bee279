// This header chooses the corners of a patch that are kept if there are more than max_corners.
#pragma once

#include <cstddef>
#include <vector>

#include "ecods/pose.hpp"
#include "query/patch/seen_along.hpp"

namespace ecods::patches {

// ExactCorners returns the exact positions of corners, and the exact normal.
class ExactCorners {
  public:
    virtual LongPoint point(std::size_t i) const = 0;
    virtual ScaledLongVector normal() const = 0;

  protected:
    ~ExactCorners() = default;
};

// Returns the indices of the `count` points that are kept, ascending. The first point is always kept. The kept points
// make the polygon with the greatest area, seen along the normal; among equal areas, the lexicographically first. If
// `count` is 2, the second point is the one furthest from the first across the normal. The points are the corners of a
// convex polygon, in order; `count` is at least 1 and less than the number of points. `points` are the exact positions,
// each coordinate rounded once, or all moved by one vector before rounding; `normal` is the unit normal, rounded once.
// Exact.
//
// A polygon with points c, i, j, ..., where c is the first point, has the sum of the areas of the triangles (c, i, j),
// (c, j, ...). So the best choice of k points that ends at j is the best choice of k - 1 points that ends at some i <
// j, and the triangle (c, i, j). Cost for m points: `count` m^2 areas, sums and comparisons, most of which doubles
// decide.
std::vector<std::size_t> choose_corners(const std::vector<Vec3>& points, const Vec3& normal, const ExactCorners& exact,
                                        std::size_t count);

}  // namespace ecods::patches
