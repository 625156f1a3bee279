// The pairs of convex solids on which distances and depths are measured: the same bits on every machine.
#pragma once

#include <vector>

#include "scenes/mesh_pairs.hpp"
#include "scenes/narrow_workloads.hpp"

namespace ecods::scenes {

enum class ConvexQuestion { distance, depth };

// Two meshes for each query.
struct ConvexWorkload : MeshPairs {
    ConvexQuestion question = ConvexQuestion::distance;
    double nominal = 0;  // the gap or the depth, about; 0 where it is any
};

// Hulls of 32 points, 60 faces, in random rotations: at gaps of 1e-1, 1e-3, 1e-6 and 1e-9, then some way into each
// other, and by depths of about 1e-3 and 1e-6; boxes in random rotations, boxes in no rotation, plates 500 times as
// wide as thick, all of which overlap; boxes, and prisms of 32 corners, that stand on each other, turned by any angle,
// with a gap or a depth of 2^-6. How near they are is asked of the library; who uses the pairs has their distances and
// depths checked.
std::vector<ConvexWorkload> convex_workloads(WorkloadSize size);

}  // namespace ecods::scenes
