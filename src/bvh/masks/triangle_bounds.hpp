// Bounds of the distances of the triangles of two leaves, in floats.
#pragma once

#include <array>
#include <cstddef>

#include "bvh/axes/distance_axes.hpp"
#include "ecods/ids.hpp"

namespace ecods {

// The corners of eight triangles on the axes of a set, by corner, axis and lane.
using AxisCorners = std::array<std::array<FloatLanes, 3>, 3>;

// Two leaves on the axes of a set.
struct LeavesOnAxes {
    alignas(32) AxisCorners x;
    alignas(32) AxisCorners y;
};
void put_on_axes(const DistanceSet& set, const TreeLeaf& x, const TreeLeaf& y, LeavesOnAxes& leaves) noexcept;

// Up to eight pairs of triangles on the axes of one set.
struct TriangleBatch {
    alignas(32) AxisCorners a;
    alignas(32) AxisCorners b;
    std::array<TrianglePair, tree_width> pairs;
    std::size_t count = 0;

    bool is_full() const noexcept { return count == tree_width; }

    // Triangle i of x and j of y, which are called `pair`.
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

// Squared distances of the pairs of a batch.
struct TriangleSquares {
    alignas(32) FloatLanes lower;                   // in units; 0 where nothing is known
    alignas(32) FloatLanes upper;                   // on the axes, of two points of the triangles; without errors
    alignas(32) std::array<FloatLanes, 3> between;  // from the one to the other
};

// Sets the squares of all pairs of the batch, and of lanes that hold no pair, too. All lanes must be numbers.
void bound_triangles(const DistanceSet& set, const TriangleBatch& batch, TriangleSquares& squares) noexcept;

}  // namespace ecods
