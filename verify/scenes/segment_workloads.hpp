// The segments on which hits are measured: the same bits on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ecods/primitives.hpp"
#include "scenes/mesh_pairs.hpp"
#include "scenes/narrow_workloads.hpp"

namespace ecods::scenes {

struct SegmentWorkload {
    std::string name;  // says bodies and kind
    std::vector<NamedMesh> meshes;
    std::vector<MeshAt> bodies;
    std::vector<Segment> queries;
    bool is_path = false;  // each segment begins where the one before ended
};

// Against tori in a random pose: chords of a ball of 1.2 times the torus's size; probes of four edges' length with
// their middle on the surface; through vertices and middles of edges, as posed and rounded. In a pose that leaves
// vertices on their lattice: exactly through vertices and middles of edges, and along edges, beyond both ends. On the
// torus of 100,000 triangles also the path of a haptic probe, which follows the surface, and dips into it each fortieth
// step, by an edge's length. Through a soup of large triangles, most of which any segment hits. And in the room of the
// report's experiment with ten thousand ships, at its density: chords from wall to wall, segments of a ship's length,
// and diagonals through another room, which holds as many ships in a tenth of the volume.
std::vector<SegmentWorkload> segment_workloads(WorkloadSize size);

// The triangles of all bodies, numbered through: those of body 0 first. Vertices are posed, and rounded.
struct PosedTriangles {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};
PosedTriangles posed_triangles(const SegmentWorkload& workload);

// The number of each body's first triangle among these.
std::vector<std::uint32_t> first_triangles(const SegmentWorkload& workload);

}  // namespace ecods::scenes
