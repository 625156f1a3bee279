// Bounds of the distances of the triangles of two leaves, in floats.
#pragma once

#include <cstdint>

#include "bvh/distance_axes.hpp"

namespace ecods {

// Of pairs of triangles, the first, second, ... in the order of LanePairs.
struct TriangleSquares {
    alignas(32) LaneSquares lower;  // in units; 0 where nothing is known
    alignas(32) LaneSquares upper;
};

// Bounds the squared distances of the pairs of lanes in `pairs`, as near_mask has them; not more than are in it.
// `set` is the first of DistanceAxes.
void bound_triangles(const DistanceSet& set, const TreeLeaf& x, const TreeLeaf& y, std::uint64_t pairs,
                     TriangleSquares& squares) noexcept;

}  // namespace ecods
