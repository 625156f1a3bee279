// The turns of two meshes on which casts are measured: the same bits on every machine.
#pragma once

#include <string>
#include <vector>

#include "ecods/turn.hpp"
#include "scenes/mesh_pairs.hpp"
#include "scenes/narrow_workloads.hpp"

namespace ecods::scenes {

// Body a turns from its pose about a pivot that stays, b rests. `a_end` is where the turn ends, rounded.
struct TurnQuery {
    MeshAt a;
    MeshAt b;
    Turn turn;
    Pose a_end;
};

struct TurnWorkload {
    std::string name;  // says mesh, angle and end
    std::vector<NamedMesh> meshes;
    std::vector<TurnQuery> queries;
};

// Tori of 320 to 100,000 triangles, and ships, each against itself, in random rotations. The pivot is a diameter from
// the middle of a, which turns by 30 or 90 degrees. It ends going straight towards the middle of b: at a gap of 1e-4
// diameters, or a twentieth of a diameter further on. Bodies are apart at the start. How far they are apart is asked of
// the library; who uses the turns has their times checked.
std::vector<TurnWorkload> turn_workloads(WorkloadSize size);

}  // namespace ecods::scenes
