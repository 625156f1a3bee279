// bound_triangles computes bounds of the distances of triangles of two leaves, in floats.
#pragma once

#include <array>
#include <cstddef>

#include "bvh/axes/distance_axes.hpp"
#include "ecods/ids.hpp"

namespace ecods {

// AxisCorners holds the corners of eight triangles on the axes of a set: [corner][axis][lane].
using AxisCorners = std::array<std::array<FloatLanes, 3>, 3>;

// Holds the triangles of two leaves, x of the first tree and y of the second, on the axes of a set.
struct LeavesOnAxes {
    alignas(32) AxisCorners x;
    alignas(32) AxisCorners y;
};
void put_on_axes(const DistanceSet& set, const TreeLeaf& x, const TreeLeaf& y, LeavesOnAxes& leaves) noexcept;

// Holds up to eight pairs of triangles, a[..][..][i] and b[..][..][i], on the axes of one set.
struct TriangleBatch {
    alignas(32) AxisCorners a;
    alignas(32) AxisCorners b;
    std::array<TrianglePair, tree_width> pairs;
    std::size_t count = 0;

    bool is_full() const noexcept { return count == tree_width; }

    // Adds the pair of triangle i of leaf x and triangle j of leaf y. `pair` has the indices of both triangles in their
    // meshes.
    void add(const LeavesOnAxes& leaves, std::size_t i, std::size_t j, const TrianglePair& pair) noexcept {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < 3; ++k) {
                a[c][k][count] = leaves.x[c][k][i];
                b[c][k][count] = leaves.y[c][k][j];
            }
        }
        pairs[count++] = pair;
    }
};

// Holds the results of bound_triangles() for the pairs of a batch, one pair in each lane.
struct TriangleSquares {
    alignas(32) FloatLanes lower;  // lower bound of the squared distance, in units; 0 if nothing is known
    alignas(32) FloatLanes upper;  // squared distance of a point of each on the axes, as computed
    alignas(32) std::array<FloatLanes, 3> between;  // vector from the point of a to the point of b
};

// Sets `squares` in all lanes, also in lanes without a pair. The coordinates of all lanes must be numbers, not NaN.
void bound_triangles(const DistanceSet& set, const TriangleBatch& batch, TriangleSquares& squares) noexcept;

}  // namespace ecods
