// The motions of two meshes on which casts are measured: the same bits on every machine.
#pragma once

#include <string>
#include <vector>

#include "scenes/mesh_pairs.hpp"
#include "scenes/narrow_workloads.hpp"

namespace ecods::scenes {

// Body a moves, b rests. Of a translation: by `motion`, and a_end is where that ends, rounded.
struct CastQuery {
    MeshAt a;
    MeshAt b;
    Vec3 motion = Vec3::Zero();
    Pose a_end;
};

struct CastWorkload {
    std::string name;  // says meshes and motions
    std::vector<NamedMesh> meshes;
    std::vector<CastQuery> queries;
    bool is_translation = true;
    bool is_hull = false;  // a's mesh is the surface of its convex hull
};

// Ships, tori of 10,000 and 100,000 triangles, and balls, against each other and against the torus, in random
// rotations. Motions along a random line through both middles, of one diameter: up to a gap, which is a share of the
// diameter, and a twentieth of the diameter beyond it. Grazing ones go past, three diameters long; aside of the middle
// by so much that the one just meets, or just misses: adjacent of 2^-40 diameters. Motions between poses end there,
// turned by a tenth of a radian. How far bodies are apart and whether grazing ones meet is asked of the library; who
// uses the motions has their times checked.
std::vector<CastWorkload> cast_workloads(WorkloadSize size);

}  // namespace ecods::scenes
