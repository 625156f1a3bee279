// Queries of two meshes, as benchmarks and tests ask them: the same bits on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace ecods::scenes {

struct MeshAt {
    std::size_t mesh_index = 0;  // in MeshPairs::meshes
    Pose pose;
};

struct MeshQuery {
    MeshAt a;
    MeshAt b;
};

struct MeshPairs {
    std::string name;
    std::vector<NamedMesh> meshes;
    std::vector<MeshQuery> queries;
};

// The two are each one mesh against itself, both copies in random rotations. Of the first, every other query hits, the
// first included: coming from afar along a random line, the copy is stopped at its first contact, to 2^-20 radii, and
// then moved on, or back, by 2^-13 to 2^-7 radii (about 1e-4 to 1e-2). A radius is that of the ball around the mesh's
// box centre. Whether poses hit is asked of the library, which answers exactly; who uses the queries as a benchmark has
// that checked.
MeshPairs near_pairs(const std::string& name, const std::shared_ptr<const Mesh>& mesh, std::size_t count,
                     std::uint32_t seed);

// The centre of the second ball lies anywhere, evenly, where the two balls overlap.
MeshPairs random_pairs(const std::string& name, const std::shared_ptr<const Mesh>& mesh, std::size_t count,
                       std::uint32_t seed);

// As near_pairs, with one gap for all, in radii. The contact is bracketed by adjacent doubles, so that gaps down to
// 1e-16 mean something; where a gap no longer changes the position, the two positions of the bracket are used.
MeshPairs gap_pairs(const std::string& name, const std::shared_ptr<const Mesh>& mesh, double gap, std::size_t count,
                    std::uint32_t seed);

}  // namespace ecods::scenes
