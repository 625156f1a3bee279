// The queries of two meshes on which distances are measured: the same bits on every machine.
#pragma once

#include <cstddef>
#include <vector>

#include "scenes/mesh_pairs.hpp"
#include "scenes/narrow_workloads.hpp"

namespace ecods::scenes {

// The name says mesh and gap.
struct DistanceWorkload : MeshPairs {
    bool is_path = false;     // each query is near the one before, of the same two bodies
    bool are_points = false;  // the first body is a point, at its pose's t; the second one's pose is the identity
};

// Two copies of a mesh, of ships, tori and real meshes, in random rotations: from afar along a random line, up to where
// their distance is the gap, a share of the mesh's diameter, to one part in 1000 and a little more. And paths, on which
// one goes round the other at a hundredth of the diameter, in steps of a hundredth of a radian. Walls of bricks, whose
// copies are in one pose and lie face to face, edge to edge or corner to corner: many features tie. Clouds of needles,
// 1e5 to 1e9 times as long as wide. Points near balls of 320 and 20,480 triangles, inside and outside. Whether poses
// are that near is asked of the library; who uses the queries has its distances checked.
std::vector<DistanceWorkload> distance_workloads(WorkloadSize size);

}  // namespace ecods::scenes
