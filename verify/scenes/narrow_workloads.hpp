// The queries of two meshes on which engines are compared and the work of the library is counted.
#pragma once

#include <filesystem>
#include <vector>

#include "scenes/mesh_pairs.hpp"

namespace ecods::scenes {

enum class WorkloadSize {
    tiny,  // for tests: a few queries, the largest mesh left out
    full,
    large,  // full, with a mesh of ten million triangles
};

// Near and random poses of the ship, tori of 10,000 and 100,000 triangles and real meshes; parts in exact contact;
// flush boxes and plates, polygons in one plane, and single triangles.
std::vector<MeshPairs> narrow_workloads(WorkloadSize size);

// The ship near contact, with gaps from 1e-3 radii down to adjacent doubles.
std::vector<MeshPairs> gap_workloads(WorkloadSize size);

// The meshes of which builds are timed, small ones first.
std::vector<NamedMesh> build_workloads(WorkloadSize size);

// Where Debian installs the meshes that the project does not make, and two of them.
std::filesystem::path models_folder();
std::vector<NamedMesh> real_meshes();

}  // namespace ecods::scenes
