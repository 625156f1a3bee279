// walk_point finds the triangles of a tree that may be nearest to a point. The walk visits the nearest nodes first.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "bvh/axes/distance_axes.hpp"
#include "bvh/walks/node_stack.hpp"

namespace ecods {

// Holds a triangle and a lower bound of its squared distance, in units of the axes.
struct NearTriangle {
    float lower;
    std::uint32_t triangle;
};

// Holds the result of walks from a point, and scratch memory that later walks reuse.
struct PointWalk {
    std::vector<NearTriangle> found;
    // `limit` is an upper bound of the squared distances of the triangles that may be nearest.
    float limit = std::numeric_limits<float>::infinity();
    std::uint64_t node_count = 0, triangle_count = 0;  // summed over all walks

    std::vector<OrderedNode> stack;
};

// Sets walk.found to all triangles that may be nearest to the point, including the triangles that contain the point,
// and walk.limit to an upper bound of the least squared distance. `axes` must be bound to the tree and the point, and
// axes.are_useful() must be true.
void walk_point(const MeshBvh& tree, const PointAxes& axes, PointWalk& walk);

}  // namespace ecods
